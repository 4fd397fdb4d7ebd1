% A steel bar: hertz, newtons, pascals; how force and stress grow with the energy.
steel = '--young 210e9 --density 7800 --area 1e-4 --length 3 --gap 1e-5';
energies = logspace(log10(1.4e-3), log10(20e-3), 12);
for k = 1:numel(energies)
  physical(k) = ask('find 150 900 --energy-ratio %.15g %s', energies(k) / 3.5e-4, steel).physical;
end
pair = plotyy(1e3 * energies, [physical.peak_force], 1e3 * energies, 1e6 * [physical.contact_time]);
xlabel(sprintf('energy [mJ] at %.1f Hz', physical(1).frequency));
ylabel(pair(1), 'peak force of the wall [N]'); ylabel(pair(2), 'contact time [\mus]');
