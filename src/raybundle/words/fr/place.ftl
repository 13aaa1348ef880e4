place-line = ligne { $line }

place-row = rangée { $row }

place-column = colonne { $column }

place-of_block = Lieu des { $of ->
     [control] points d'appui
     *[positions] positions
    } : { NUM($latitude_deg, decimals: 4) }° { $north }, { NUM($longitude_deg, decimals: 4) }° { $east } (WGS 84).
