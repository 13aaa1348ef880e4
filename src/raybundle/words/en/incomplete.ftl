# $oriented = 12
# $photographs = 40
# $limit = 0.5
incomplete = Only { $oriented } of { $photographs } photographs are oriented (limit { PERCENT($limit) } %).
    .do = Take photographs with 60 % overlap or more, or orient the photographs of each object separately.
