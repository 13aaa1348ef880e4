distance-sigma_not_positive = Strecke { $row }: Die Standardabweichung ist { $sigma }.
    .do = Einen Wert über 0 angeben.
