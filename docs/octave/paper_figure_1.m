% Energy over frequency: the modes as curves, the families of order up to 12 above them.
answer = ask('modes');
for k = 1:numel(answer.modes)
  mode = answer.modes(k);
  ends = mode.period_range(:, 1) ./ mode.period_range(:, 2);
  T = linspace(ends(1), ends(2), 200);
  T = T(2:end-1);
  energy = 1 ./ (mode.inverse_sqrt_energy(1) * T - mode.inverse_sqrt_energy(2)).^2;
  semilogy(4 ./ T, energy, 'k'); hold on;
end
answer = ask('families');
for k = 1:numel(answer.families)
  family = answer.families(k);
  semilogy(family.frequency_ratio * [1 1], [family.least_energy_ratio 50], ...
           'Color', [0.34 0.71 0.91]);
end
semilogy(8 / 7, 20, 'o', 'Color', [0.84 0.37 0], 'MarkerFaceColor', [0.84 0.37 0]);
axis([1 1.6 1 50]); xlabel('\omega/\omega_1'); ylabel('E/E_1'); hold off;
