% Into how many pieces do the motions of one energy fall?
ratios = [4.1 20 100 299 300 301 400 599];
pieces = zeros(size(ratios));
for k = 1:numel(ratios)
  pieces(k) = ask('continuum 150 900 --energy-ratio %g --points 2', ratios(k)).components;
end
loglog(ratios, pieces, 'o-');
xlabel('E/E_1'); ylabel('pieces'); axis([4 700 0.5 300]);
assert(isequal(pieces, [1 1 1 1 1 150 150 150]));
