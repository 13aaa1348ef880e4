# $row = 2
# $sigma = -0.1
distance-sigma_not_positive = Distance { $row }: its standard deviation is { $sigma }.
    .do = Give a value above 0.
