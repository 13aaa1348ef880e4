"""Networks of stations about an object: site, candidates, aims, and the plan."""
