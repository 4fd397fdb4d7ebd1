% A continuum of motions of one energy: the strain along the bar at t = 0, against lambda.
ask('continuum 150 900 --energy-ratio 20 --csv curve.csv');
curve = csvread('curve.csv', 1, 0);                  % lambda, a_1 .. a_N, b_1 .. b_N
N = (size(curve, 2) - 1) / 2;
a = curve(:, 2:N+1);
b = curve(:, N+2:end);
assert(all(abs(sum(a.^2 + b.^2, 2) / sum(a(1,:).^2 + b(1,:).^2) - 1) < 1e-12));   % one energy
imagesc(((1:N) - 0.5) / N, curve(:, 1), b - a);
axis xy; colorbar;
xlabel('x/L'); ylabel('\lambda: pause of the force [L/c]'); title('strain at t = 0');
