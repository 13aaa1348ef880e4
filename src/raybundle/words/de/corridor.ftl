corridor-sharp_turn = Die Linie knickt an der Ecke { $corner } um { NUM($turn_deg, decimals: 0) }° ab (Grenze { NUM($most_deg, decimals: 0) }°).
    .do = Die beiden Teile als eigene Korridore planen.

corridor-tight_bend = Der Knick an der Ecke { $corner } ist zu eng für einen Flugstreifen { NUM($offset_m, decimals: 1) } m neben der Linie.
    .why = Das Stück dort ist { NUM($length_m, decimals: 1) } m lang.
    .do = Die Ecke löschen oder einen schmaleren Korridor angeben: { OPTION("width") }.
