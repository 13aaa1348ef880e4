snooping_masked = Des fautes se masquent peut-être : sigma0 vaut encore { $sigma0 } après { $rejected } rejets.
