distance-sigma_not_positive = Distance { $row } : son écart-type est { $sigma }.
