function show_motion(file)
  % Draws a table that --motion wrote: displacement over place and time, black where the tip goes.
  table = csvread(file, 1, 0);                       % time, x, displacement, velocity, strain, x_cell
  x = unique(table(:, 2));
  t = unique(table(:, 1));
  u = reshape(table(:, 3), numel(x), numel(t));
  imagesc(t, x, 1e3 * u);
  axis xy;
  xlabel('t [s]'); ylabel('x [m]'); title('displacement [mm]'); colorbar;
end
