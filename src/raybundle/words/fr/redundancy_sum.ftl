redundancy_sum = La somme des nombres de redondance vaut { NUM($sum, decimals: 6) } au lieu de { $redundancy }.
