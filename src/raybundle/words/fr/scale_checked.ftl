scale_checked = L'échelle de { $bars } règle(s) ({ $ids }) est confirmée par { $n } longueur(s) de contrôle.
