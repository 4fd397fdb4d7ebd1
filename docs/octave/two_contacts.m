% Two contacts of different length in one period.
answer = ask('find 10 120 30 120 --cells 40 --motion two.csv');
fprintf('%s of dimension %d, %.4f to %g E_1\n', answer.solution_set.kind, ...
       answer.solution_set.dimension, answer.energy_ratio_range);
show_motion('two.csv');
