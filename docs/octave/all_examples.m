% Runs every example of this folder and keeps its picture beside it: octave-cli all_examples.m
warning('off', 'all');
graphics_toolkit('gnuplot');
set(0, 'defaultfigurevisible', 'off');
function run_example(name)
  figure(1, 'visible', 'off'); clf;
  printf('%s\n', name);
  run([name '.m']);
  print('-dpng', '-r100', [name '.png']);
end
names = cellfun(@(file) file(1:end-2), {dir('*.m').name}, 'UniformOutput', false);
for name = setdiff(names, {'all_examples', 'ask', 'show_motion'})
  run_example(name{1});
end
