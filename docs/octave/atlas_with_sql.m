% Every schedule of N = 300 decided; the families near a frequency and an energy.
if exist('atlas.sqlite', 'file'), delete('atlas.sqlite'); end
done = ask('atlas --database atlas.sqlite --max-free 2400');
near = ask('atlas --database atlas.sqlite --near 8/7 20 --schedules');
fprintf('%d family, %d schedules\n', numel(near.families), numel(near.schedules));
ask('atlas --database atlas.sqlite --max-free 2400 --csv families.csv');
table = csvread('families.csv', 1, 0);               % words are read as 0
semilogy(table(:, 9), table(:, 14), '.');
xlabel('\omega/\omega_1'); ylabel('least E/E_1'); title('the families of N = 300');
axis([0.9 6 1 1e5]);
