corridor-sharp_turn = Die Richtung der Linie ändert sich am Knickpunkt { $corner } um { NUM($turn_deg, decimals: 0) }° (Grenze { NUM($most_deg, decimals: 0) }°).
    .do = Die beiden Teile als eigene Korridore planen.

corridor-tight_bend = Der Knick am Knickpunkt { $corner } ist zu eng für einen Flugstreifen { NUM($offset_m, decimals: 1) } m neben der Linie.
    .why = Das Linienstück dort ist { NUM($length_m, decimals: 1) } m lang.
    .do = Den Knickpunkt löschen oder einen schmaleren Korridor angeben: { OPTION("width") }.
