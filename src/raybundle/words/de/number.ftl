number-not_finite = { $entry } ist { $value }, keine endliche Zahl.
    .do = Eine Zahl angeben.

number-too_small = { $entry } ist { $value }.
    .do = Einen Wert über { $limit } angeben.

number-below = { $entry } ist { $value }.
    .do = Einen Wert von mindestens { $limit } angeben.

number-too_large = { $entry } ist { $value }.
    .do = Einen Wert von höchstens { $limit } im Betrag angeben.
