% The families of motions: period against order, coloured by the least energy.
families = ask('families').families;
fraction = [families.period_ratio];
period = fraction(1, :) ./ fraction(2, :);
scatter([families.order], period, 60, log10([families.least_energy_ratio]), 's', 'filled');
xlabel('order w'); ylabel('period cT/L'); title('log_{10} of the least E/E_1'); colorbar;
fprintf('%d families, the first of period %g L/c\n', numel(families), period(1));
