function answer = ask(varargin)
  % The program's JSON answer to one call: ask('find 150 900 --cells %d', 300).
  % Status 1, proved that none exists, is an answer; anything higher is an error.
  call = ['signorini ' sprintf(varargin{:}) ' --quiet --format json'];
  [status, text] = system(call);
  if status > 1
    error('%s\n%s', call, text);
  end
  answer = jsondecode(text);
end
