moved_ambiguous = Punkt { $point } gilt als bewegt; stattdessen kann sich { $others } bewegt haben.
    .why = Beide Erklärungen passen (F { NUM($F, decimals: 2) } ohne { $point }).
    .do = Mehr gemeinsame Punkte messen.

moved_ambiguous-other = Ohne { $point } stimmt der Rest ebenso gut überein (F { NUM($F, decimals: 2) }).
