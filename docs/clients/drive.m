% A closed loop with lunoid, in GNU Octave 7 or newer: drive ahead, look, decide, drive on.
% octave-cli docs/clients/drive.m STEPS lunoid serve scenarios/first-light.toml --record runs/driven
1;

function [header, planes] = ask(to, from, request)
  % The answer to a request, and its planes by name, with the last axis first.
  text = unicode2native(jsonencode(request), "UTF-8");
  fwrite(to, [uint8("lunoid.1"), typecast(uint64([numel(text), 0]), "uint8"), text]);
  fflush(to);
  lengths = typecast(take(from, 24)(9:24), "uint64");
  header = jsondecode(native2unicode(take(from, double(lengths(1))), "UTF-8"));
  planes = struct();
  listed = {};
  if (isfield(header, "planes")) listed = num2cell(header.planes); end
  types = struct("u8", "uint8", "u16", "uint16", "u32", "uint32", "i32", "int32", "f32", "single", "f64", "double");
  sizes = struct("u8", 1, "u16", 2, "u32", 4, "i32", 4, "f32", 4, "f64", 8);
  for k = 1:numel(listed)
    plane = listed{k};
    shape = reshape(plane.shape, 1, []);
    values = typecast(take(from, prod(shape) * sizes.(plane.dtype)), types.(plane.dtype));
    planes.(plane.name) = reshape(values, [fliplr(shape), 1]);
  end
  if (isfield(header, "error")) error("%s", header.error.problems(1).title); end
end

function bytes = take(from, count)
  % So many bytes of a pipe; reading waits for them.
  bytes = zeros(1, 0, "uint8");
  while (numel(bytes) < count)
    more = fread(from, count - numel(bytes), "uint8=>uint8").';
    if (isempty(more))
      if (feof(from)) fclear(from); end
      pause(0.001);
    end
    bytes = [bytes, more];
  end
end

words = argv();
steps = str2double(words{1});
[to, from, process] = popen2(words{2}, words(3:end));
seen = ask(to, from, struct("id", 1, "do", "frame", "frame", 0)).ok;
for step = 1:steps
  [seen, planes] = ask(to, from, struct("id", 2 * step, "do", "step", "pose", seen.pose));
  printf("%s %.6f\n", seen.ok.hash, mean(double(planes.picture(:))));
  % Your controller here.
  seen = ask(to, from, struct("id", 2 * step + 1, "do", "ahead", "pose", seen.ok.pose, "metres", 0.5, "turn_deg", 0.5)).ok;
end
disp(jsonencode(ask(to, from, struct("id", 2 * steps + 2, "do", "record")).ok));
fclose(to);
fclose(from);
waitpid(process);
