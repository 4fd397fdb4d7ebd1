% Forced and damped: impulse on the wall against frequency, and the fold.
ask('response --damping 0.02 --force tip --amplitude 2e-4 --from 0.9 --to 1.4 --cells 60 --csv response.csv');
table = csvread('response.csv', 1, 0);               % columns 2, 9: frequency_ratio, impulse
table = table(table(:, 9) > 0, :);
plot(table(:, 2), 1e3 * table(:, 9), '.');
xlabel('\omega/\omega_1'); ylabel('impulse on the wall [mN s]');
