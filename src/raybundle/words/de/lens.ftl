lens-not_positive = { $entry } = { $value } ist nicht möglich.
    .do = Einen Wert über 0 angeben.

lens-focus_too_near = Ein Objektiv mit c = { $c_mm } mm lässt sich nicht auf { $focus_m } m fokussieren.
    .do = Eine größere Fokusentfernung angeben.
