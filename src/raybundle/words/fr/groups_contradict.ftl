groups_contradict = { $groups } groupe(s) de valeurs données se contredisent : { $solved ->
     [yes] sigma0 vaut { $sigma0 }
     *[no] le bloc n'a pas de solution
    } avec tous.

groups_contradict-group = { $group ->
     [bars] Barres d'échelle
     [positions] Positions
     *[control] Points d'appui
    } ({ $n }) : sans ce groupe, sigma0 vaut { $sigma0 }.
