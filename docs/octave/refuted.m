% A proof that (5, 40) has no motion on 10 cells, added up by hand.
N = 10; contact = 5; flight = 40;
proof = ask('find %d %d --cells %d', contact, flight, N).certificate;
x = eye(2 * N);                                      % a_1 .. a_N, b_1 .. b_N, of the initial state
p = zeros(contact + flight, 2 * N);                  % what arrives at the tip in each step
for m = 1:contact + flight
  p(m, :) = x(N, :);
  echo = (1 - 2 * (m <= contact)) * x(N, :);         % turned round in contact, kept in flight
  x = [-x(N+1, :); x(1:N-1, :); x(N+2:end, :); echo];
end
rows = {x - eye(2 * N), -p(1:contact, :), cumsum(p(contact+1:end, :))};   % (30), (10), (12)
sums = {proof.periodicity, proof.pressure, proof.penetration};
total = proof.gap * [-ones(1, N) ones(1, N)];        % (31), whose right side is N
for k = 1:3
  if ~isempty(sums{k})
    total = total + sums{k}(:, 2)' * rows{k}(sums{k}(:, 1) + 1, :);
  end
end
assert(~any(total) && proof.gap * N < 0);            % 0 < 0: there is no motion
spy([x - eye(2 * N); p]); xlabel('unknown'); ylabel('row'); title('rows of (30), (10), (12)');
