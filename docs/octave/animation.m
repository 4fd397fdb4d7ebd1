% A moving picture, drawn by the program, and four of its instants.
ask('find 15 90 --cells 30 --animate case.gif --motion case.csv');
table = csvread('case.csv', 1, 0);
t = unique(table(:, 1));
for k = 1:4
  now = table(table(:, 1) == t(1 + round((k - 1) * numel(t) / 4)), :);
  subplot(2, 2, k);
  plot(now(:, 2), 1e3 * now(:, 3), 'b', [1 1], [-2 1], 'k:');
  axis([0 1 -2.2 1.2]); text(0.05, -1.8, sprintf('t = %.3f s', now(1, 1)));
  if k > 2, xlabel('x [m]'); end
  if mod(k, 2), ylabel('u [mm]'); end
end
