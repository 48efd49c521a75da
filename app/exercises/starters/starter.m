1;  % a script

function x = answer (c)
  NAME = c.NAME;
  x = 0;  % a number, a column, or a matrix
end

data = jsondecode (fread (stdin, Inf, 'char=>char')');
answers = {};
for k = 1:numel (data.cases)
  if (iscell (data.cases)) c = data.cases{k}; else c = data.cases(k); end
  answers{k} = answer (c);
end
printf ('%s\n', jsonencode (struct ('answers', {answers})));
