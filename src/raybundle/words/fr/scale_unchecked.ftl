scale_unchecked = L'échelle repose sur { $n } règle(s) ({ $ids }) ; aucune autre longueur ne la confirme.
