# $rounds = 40
snooping_unfinished = Data snooping stopped after { $rounds } rounds; suspected blunders remain.
    .why = Remaining blunders distort the result.
    .do = Check the suspected observations in the report.
