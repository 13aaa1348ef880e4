corridor-sharp_turn = La ligne tourne de { NUM($turn_deg, decimals: 0) }° au sommet { $corner } (limite { NUM($most_deg, decimals: 0) }°).

corridor-tight_bend = Le virage au sommet { $corner } est trop serré pour une ligne de vol à { NUM($offset_m, decimals: 1) } m.
