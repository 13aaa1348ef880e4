memory-no_room = Pas de place pour un tableau de { $size_mb } Mo ({ $detail }).
