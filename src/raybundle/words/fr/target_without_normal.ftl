target_without_normal = { $n } cible(s) ronde(s) non corrigée(s) de l'excentricité, faute de normale connue : { $ids }.
