% A stepped bar, 4 + 4 cells, the outer ones with 1.3 times the impedance: linear programs decide.
exists = zeros(4, 39);
for contact = 1:4
  for free = 20:39
    answer = ask('find %d %d --cells 8 --segments 4:1,4:1.3 --objective any', contact, free);
    exists(contact, free) = strcmp(answer.status, 'found');
  end
end
[contact, free] = find(exists);
plot(free, contact, 'o'); axis([19 40 0 5]);
xlabel('flight steps n_f'); ylabel('contact steps n_c'); title('motions of a stepped bar');
