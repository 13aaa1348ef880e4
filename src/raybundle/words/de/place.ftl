place-line = Zeile { $line }

place-row = Datenzeile { $row }

place-column = Spalte { $column }

place-of_block = Ort der { $of ->
     [control] Passpunkte
     *[positions] Positionen
    }: { NUM($latitude_deg, decimals: 4) }° { $north }, { NUM($longitude_deg, decimals: 4) }° { $east } (WGS 84).
