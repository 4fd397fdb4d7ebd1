% One machine, one force, two starts: it stays quiet, or it hammers.
ask('find 150 900 --state pulled.csv');
force = '--damping 0.02 --force tip --amplitude 2e-4 --frequency 1.15 --periods 60';
quiet = ask('simulate --rest %s --tip quiet.csv', force);
hammers = ask('simulate --from pulled.csv %s --tip hammers.csv', force);
a = csvread('quiet.csv', 1, 0);
b = csvread('hammers.csv', 1, 0);
last = @(tip) tip(tip(:, 1) > tip(end, 1) - 30, :);
a = last(a); b = last(b);
plot(a(:, 1), 1e3 * a(:, 2), 'b', b(:, 1), 1e3 * b(:, 2), 'r', a([1 end], 1), [1 1], 'k--');
axis([a(1, 1) a(end, 1) -3 2]);
legend('from rest', 'pulled and let go', 'wall'); xlabel('t [s]'); ylabel('tip [mm]');
assert(quiet.contacts == 0 && hammers.contacts > 50);
