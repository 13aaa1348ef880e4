stage_summary-adjustment = σ₀ { NUM($sigma0, decimals: 3) }.

stage_summary-matching = { $pairs } { $pairs ->
        [one] Paar
        *[other] Paare
    }, { $skipped } auf den ersten Blick verschieden, { $verified } bestätigt.

stage_summary-matching_rounds = { $pairs } von { $of } Paaren: { $likely } wahrscheinliche, { $common } mit gemeinsamen Nachbarn, { $between } zwischen Teilen; { $skipped } auf den ersten Blick verschieden, { $verified } bestätigt.

stage_summary-photographs = { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    }, { $refused } abgelehnt.

stage_summary-scenes = { $n } { $n ->
        [one] Szene
        *[other] Szenen
    }, { $refused } abgelehnt.

stage_summary-precision = { $n } von { $of } Merkmalen neu gemessen, { $added } Strahlen ergänzt, { $used } verwendet.

stage_summary-scene_pairs = { $n } { $n ->
        [one] Szenenpaar
        *[other] Szenenpaare
    }, { $verified } bestätigt.

stage_summary-scene_points = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } aus Szenen.

stage_summary-start = { $n } von { $of } Aufnahmen{ $parts ->
        [1] {""}
        *[other] {" "}in { $parts } Teilen
    }, { $points } Punkte.

stage_summary-targets = { $n } { $n ->
        [one] Zielmarke
        *[other] Zielmarken
    } gelesen.

stage_summary-by_features = { $names } { $n ->
        [one] verwendet
        *[other] verwenden
    } Positionen und Standardabweichungen der Merkmale.
    .why = Die Kleinste-Quadrate-Zuordnung misst dort zu wenige Punkte (unscharfe oder sehr verschiedene Aufnahme).

stage_summary-scene_precision = { $n } von { $of } in Szenen, { $added } Strahlen ergänzt.

stage_summary-wide_baselines = { $pairs } { $pairs ->
        [one] weiteres Paar
        *[other] weitere Paare
    }, { $verified } bestätigt, { $joined } { $joined ->
        [one] Aufnahme
        *[other] Aufnahmen
    } verbunden; Rechenzeit { NUM($cpu_s, decimals: 0) } von { NUM($budget_s, decimals: 0) } s.
