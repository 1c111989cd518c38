\\ Which of the sums vanish, by PARI/GP: the remainder of a polynomial modulo the cyclotomic one, which is at hand.
read(getenv("SUMS"));
version_name = Str("PARI/GP ", version()[1], ".", version()[2], ".", version()[3]);
{ verdict(s, P) = my(v = vector(s[1])); forstep(j = 2, #s, 2, v[s[1] - s[j]] += s[j + 1]); Pol(v) % P == 0 };
at_hand = 1;
{ from_angles(s, P) = my(N = at_hand);
  for(j = 1, #s, N = lcm(N, denominator(s[j][1])));
  my(v = vector(N)); for(j = 1, #s, v[N - N * s[j][1]] += s[j][2]); Pol(v) % P == 0 };
{ measure(what, decide, sums, N) = at_hand = N; my(P = polcyclo(N), start, zeros, rounds = 1, least = oo, spent);
  zeros = sum(i = 1, #sums, decide(sums[i], P));
  while(1, start = getwalltime(); for(r = 1, rounds, for(i = 1, #sums, decide(sums[i], P))); spent = getwalltime() - start; if(spent > 40, break); rounds *= 2);
  for(batch = 1, 11, start = getwalltime(); for(r = 1, rounds, for(i = 1, #sums, decide(sums[i], P))); least = min(least, getwalltime() - start));
  print(version_name, "; ", what, "; ", N, "; ", strprintf("%.1f", least * 1e6 / (rounds * #sums)), "; ", zeros) };
{ forstep(first = 1, #sums, 28,
    my(some = sums[first .. first + 27], N = some[1][1]);
    if(N > 10^6, print(version_name, "; verdict; ", N, "; none; a polynomial of that many terms");
      print(version_name, "; verdict from rational angles; ", N, "; none; a polynomial of that many terms"); next);
    measure("verdict", verdict, some, N);
    measure("verdict from rational angles", from_angles, [vector(#s \ 2, j, [s[2 * j] / N, s[2 * j + 1] / 2]) | s <- some], N)) };
quit
