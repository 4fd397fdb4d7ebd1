% Both ends of that continuum: two motions of one schedule and one energy.
lambda = {'0', '0.4'};
for member = [1 2]
  ask('continuum 150 900 --energy-ratio 20 --member %s --state end.csv', lambda{member});
  ask('find 150 900 --energy-ratio 20 --objective nearest --target end.csv --motion end_motion.csv');
  subplot(1, 2, member);
  show_motion('end_motion.csv');
end
