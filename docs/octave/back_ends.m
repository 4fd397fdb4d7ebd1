% The same question put to several back ends, which know nothing of each other.
names = {'closed-form', 'glpk-simplex', 'glpk-exact', 'ipopt', 'nlopt-slsqp'};
forms = {'auto', 'state'};
for k = 1:numel(names)
  answer = ask('find 150 900 --solver %s --formulation %s --objective any', names{k}, forms{1 + (k > 1)});
  worst = max(cell2mat(struct2cell(answer.residuals)));
  seconds(k) = answer.solver.seconds;
  fprintf('%-14s %-6s E = %8.3f E_1, residual %.0e, %.2g s\n', names{k}, answer.status, ...
         answer.energy_ratio, worst, seconds(k));
end
barh(log10(seconds)); set(gca, 'ytick', 1:numel(names), 'yticklabel', names);
xlabel('log_{10} of the seconds');
