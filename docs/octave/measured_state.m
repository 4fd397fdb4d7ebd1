% From a simplex to a measured state: of all motions of (150, 900) the one nearest to twelve gauges.
x = linspace(0.04, 0.96, 12)';
noise = 1e-4 * sin(37 * (1:12)');
velocity = 2e-3 * (x > 0.5) + noise;
strain = 2e-3 * (x < 0.5) - noise;
file = fopen('gauges.csv', 'w');
fprintf(file, 'x,velocity,strain\n');
fprintf(file, '%g,%g,%g\n', [x velocity strain]');
fclose(file);
answer = ask('find 150 900 --objective nearest --target gauges.csv --state nearest.csv');
state = csvread('nearest.csv', 1, 0);                % x, a, b, velocity, strain, displacement
plot(state(:, 1), state(:, 5), 'b', x, strain, 'bo', state(:, 1), state(:, 4), 'r', x, velocity, 'rx');
legend('strain', 'measured', 'velocity [m/s]', 'measured', 'Location', 'northeast');
axis([0 1 -5e-4 3.6e-3]); xlabel('x [m]'); title(sprintf('E = %.3f E_1', answer.energy_ratio));
