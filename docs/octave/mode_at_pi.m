% The main mode at T = pi: no grid has this period.
answer = ask('mode 4 -1 --period %.17g --motion mode.csv --cells 100', pi);
assert(abs(answer.energy_ratio - 1 / (pi - 3)^2) < 1e-9 * answer.energy_ratio);
show_motion('mode.csv');
