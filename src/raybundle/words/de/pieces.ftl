pieces-degree = Abschnitte vom Grad { $degree } sind nicht möglich.
    .do = Grad 1, 2 oder 3 angeben.

pieces-continuity = Stetigkeit { $continuity } ist für Abschnitte vom Grad { $degree } nicht möglich.
    .do = Eine Stetigkeit von 0 bis { $most } angeben.

pieces-count = { $n } Abschnitte haben { $coefficients } Koeffizienten; möglich sind 1 bis { $most }.
    .do = Weniger Abschnitte angeben, mindestens einen.
