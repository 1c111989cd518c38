# Which of the sums vanish, by GAP: cyclotomic numbers in normal form.
Read(GAPInfo.SystemEnvironment.SUMS);
some := []; conductor := 1;
name := Concatenation("GAP ", GAPInfo.Version);
verdict := s -> Sum([1 .. QuoInt(Length(s), 2)], j -> s[2 * j + 1] * E(s[1]) ^ s[2 * j]) = 0;
from_angles := s -> Sum(s, t -> t[2] * E(DenominatorRat(t[1])) ^ NumeratorRat(t[1])) = 0;
run := function(decide, some, rounds)
  local start, round, s;
  start := NanosecondsSinceEpoch();
  for round in [1 .. rounds] do for s in some do decide(s); od; od;
  return NanosecondsSinceEpoch() - start;
end;
measure := function(what, decide, some, conductor)
  local zeros, rounds, least, batch, tenths;
  zeros := Number(some, decide);
  rounds := 1;
  while run(decide, some, rounds) < 4 * 10^6 do rounds := 2 * rounds; od;
  least := Minimum(List([1 .. 21], batch -> run(decide, some, rounds)));
  Print(name, "; ", what, "; ", conductor, "; ", QuoInt(least, rounds * Length(some)), "; ", zeros, "\n");
end;
for first in [1, 29 .. Length(sums) - 27] do
  some := sums{[first .. first + 27]};
  conductor := some[1][1];
  if conductor >= 2^28 then
    Print(name, "; verdict; ", conductor, "; none; a conductor from 2^28 on\n");
    Print(name, "; verdict from rational angles; ", conductor, "; none; a conductor from 2^28 on\n");
  else
    measure("verdict", verdict, some, conductor);
    measure("verdict from rational angles", from_angles,
      List(some, s -> List([1 .. QuoInt(Length(s), 2)], j -> [s[2 * j] / conductor, s[2 * j + 1] / 2])), conductor);
  fi;
od;
QUIT_GAP(0);
