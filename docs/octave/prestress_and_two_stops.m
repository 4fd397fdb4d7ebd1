% Pressed at rest (a negative gap), and between two stops (a phase on the left one is L:NC NF).
calls = {'find 60 40 --cells 40 --gap=-1e-3', 'find 10 50 L:10 50 --cells 40 --second-stop 1e-3'};
for k = 1:2
  answer = ask('%s --motion scene.csv', calls{k});
  table = csvread('scene.csv', 1, 0);
  tip = table(table(:, 2) == max(table(:, 2)), :);   % x = L
  subplot(2, 1, k);
  plot(tip(:, 1), 1e3 * tip(:, 3), 'k'); hold on;
  for stop = [answer.stops.place]
    plot(tip([1 end], 1), 1e3 * stop * [1 1], 'r--');
  end
  hold off; axis([0 tip(end, 1) -2.3 1.3]); ylabel('tip [mm]');
  title(sprintf('E = %g E_1', answer.energy_ratio));
end
xlabel('t [s]');
