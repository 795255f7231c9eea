"""Words that must not come back, and what to write instead. Every pattern was checked on the whole tree: of twenty hits at least
nineteen were wrong. A word that is wrong in one sense only is listed in that sense, or not listed.

    WORDS: for prose (comments, messages, pages); case does not matter
    NAMES: for identifiers and file names, whose words are joined by _ : RangeBisection is range_bisection
    HEADINGS: for headings of pages
"""
import re

RATE = ("seconds?|nanoseconds?|microseconds?|milliseconds?|ns|us|ms|µs|bytes|bits|floats|doubles|kB|KB|MB|entries|words|pages|"
        "allocations?|look-ups?|probes?|once|one|two|three|four|six|ten|tens|hundreds?|thousands?|objects|rows|pairs|comparisons?")
UNIT = ("row|join|host|pair|object|commit|node|statement|query|question|second|call|corner|leaf|lane|triangle|piece|axis|box|report|"
        "batch|entry|id|transaction|edge|page|table|change|place|file|step|probe|tile|year|day|term|product|heading|mesh|outline|"
        "word|level|thread|key|stripe|cell|column|slab|connection|map|scan|room|line|host|intruder")

WORDS = [(re.compile(pattern, re.I), write) for pattern, write in [
    (r"\btold\b(?! apart)", "reported, logged, published; given; decided"),
    (r"\btells\b(?! (?:\w+ ){0,4}apart)", "reports, says, decides"),
    (r"(?<!cannot )(?<!not )(?<!can )(?<!could )(?<!to )\btell\b(?! (?:\w+ ){0,6}apart)", "report, say, decide"),
    (r"\bask(?:s|ed|ing)?\b", "query, queried; call, read; asked for: requested"),
    (r"\bquestions?\b", "query (the struct that describes one by its name in backticks)"),
    (r"\bmoments?\b", "time, instant"),
    (r"(?<![.\w\[(])begin\b(?![\w(.\]])(?!\s*(?:<|=|>|\+|and end\b|or end\b))|\b(?:begins|began|begun|beginnings?|beginning)\b(?!\()",
     "start, starts"),
    (rf"\b(?:{RATE}) an? (?:{UNIT})\b(?! (?:is|are|has|says|reports|gives|holds|that|of)\b)", "per"),
    (r"\bthe (?:most|least)\b(?! recent| common| significant| frequent| likely| [a-z]+ful\b)", "max, min; upper bound, lower bound; the smallest, the largest"),
    (r"\b(?:object|point|place|corner|pair|ship|box)'s ways?\b|\b(?:bent|straight|changed|rough|plain) ways?\b|\bby other ways\b",
     "path, trajectory, method"),
    (r"\brooms\b|\broom's\b|\b(?:one|each|every|other|another|this|which|inside a|a) room\b(?! for)|\bthe room\b(?! for| on| to| that| of above)",
     "module"),
    (r"\bto the letter\b", "reference implementation of the paper"),
    (r"\bfor every day\b", "production"),
    (r"\ba look\b(?![- ](?:up|ahead))|\b(?:million|thousand|hundred|fewer|more|many) looks\b", "an evaluation, a test, a read"),
    (r"\bmend(?:s|ed|ing)?\b", "fix, repair"),
    (r"\bbites\b", "pitfalls"),
    (r"\bbelie(?:f|fs|ve|ves|ved)\b", "valid, revalidate, read state; trust"),
    (r"\bheed(?:s|ed|ing)?\b", "poll, check; set_interrupt"),
    (r"\b(?:a|the|no|each|every|its|known|certain|possible|earliest|latest|first|last|next|two|of|among) (?:known |possible )?stays?\b"
     r"(?! (?:in|as|at|within|the|where)\b)|\ball stays\b", "uncertain interval, interval union"),
    (r"\bas (?:it|they|one) l(?:ie|ies)\b|\bhow (?:it|they) l(?:ie|ies)\b|\bl(?:ie|ies) aslant\b", "pose, rotated"),
    (r"\bcut (?:outline|mesh)(?:s|es)?\b", "shared outline, shared mesh"),
    (r"\bplates?\b", "bounding disc, slab"),
    (r"\bkits?\b", "traits, policy"),
    (r"\bparting\b", "separating, separation"),
    (r"\badvice\b", "manoeuvre, recommendation"),
    (r"\bpart by part\b", "one partition (chunk, interval) at a time"),
    (r"\bfor ever\b|\blawful\b", "unbounded, permanently, always"),
    (r"\b(?:is|are|be|was|were) none\b(?! of\b| left\b)", "does not exist, no row; is not a …"),
    (r"\bwhoever\b|\bwhomever\b|\bwhom\b", "the caller, a reader, the object that"),
    (r"(?<!person )(?<!people )(?<!caller, )(?<!users )(?<!user )(?<!readers )(?<!reader )\bwho\b", "the caller, the object that, which"),
    (r"\b(?:no|some|every|any)body\b", "no object, no caller, another connection, all objects"),
    (r"\b(?:is|are|be|being) (?:certainly )?(?:not )?met\b", "in contact, satisfied, reached"),
    (r"\bby (?:itself|themselves)\b", "separately, alone, automatically"),
    (r"\banew\b", "again, from scratch; rebuilt, recomputed"),
    (r"\bsquare to\b", "perpendicular to"),
    (r"\bdoors?\b", "public header, interface"),
    (r"\bhangs? together\b", "is connected; a connected component"),
    (r"\blets? go\b", "releases, discards"),
    (r"\bvouch(?:es|ed)?\b", "guarantee, validate, certify"),
    (r"\bleaps?\b", "step (of conservative advancement)"),
    (r"\(\d[\d.,]* in the middle\)", "median"),
    (r"\bnought\b|\bwhence\b|\baslant\b", "zero, from which, rotated"),
]]

# Of identifiers in snake_case: words between _ or at an end. `told` is a column of stored watches, `asked` and `anew` are keys of
# their _meta.
NAMES = [(re.compile(rf"(?:^|_)(?:{pattern})(?=_|$)"), write) for pattern, write in [
    (r"asked|asks?", "queried, query, requested"),
    (r"told|tells?", "reported, logged"),
    (r"moments?", "time, times, instant"),
    (r"begins|begun", "starts, start"),
    (r"heeds?", "set_interrupt, poll"),
    (r"belie(?:f|ves?|ved)", "valid, revalidate, read_state"),
    (r"stays?", "uncertain_interval, interval_union"),
    (r"lies?", "pose, rotated"),
    (r"cut_(?:outlines?|mesh|meshes)", "shared_outline, shared_mesh"),
    (r"plates?", "bounding_disc, slab"),
    (r"kits?", "traits, policy"),
    (r"play", "inflation"),
    (r"parting", "separating"),
    (r"advice", "manoeuvre"),
    (r"met_intruders?", "intruder"),
    (r"touched", "exact_avoidance, touching"),
    (r"depth_in", "signed_distance"),
    (r"(?<!at_)most", "max, upper_bound; support"),
    (r"(?<!at_)least", "min, lower_bound"),
    (r"ways?", "path, trajectory, context, method, crossing"),
    (r"looks", "evaluations"),
    (r"for_?ever", "unbounded"),
    (r"powers", "coefficients"),
    (r"letter", "reference"),
    (r"anew", "again; rebuild, recompute"),
    (r"nobody|somebody|everybody|whoever|who|whom", "none, any, all"),
    (r"growing(?=/)", "clearance"),
    (r"rooms", "modules"),
]]
# Names of stored columns, and words in another sense.
LEGITIMATE_NAMES = re.compile(r"^(?:t_min|until_least|is_majority|is_letter|letter|letter_of|limit_letter|keeps_leaf|looks_ahead)$")
STORED_COLUMNS = re.compile(r"(?:^|_)(?:asked|told|anew)(?=_|$)")

HEADINGS = [(re.compile(pattern, re.I), write) for pattern, write in [
    (r"^what bites$", "Pitfalls"),
    (r"^who (?:does|keeps|knows) it$", "name the subject"),
    (r"^not what was expected$", "Troubleshooting"),
    (r"^texts of other systems$", "Import formats"),
    (r"^what is noticed of tampering$|^what is checked$", "Corruption detection"),
    (r"^rooms$", "Modules"),
    (r"^one state$", "Shared state of a connection"),
    (r"^the paper beside it$", "Reference implementation of the paper"),
    (r"^words$", "Glossary"),
    (r"^how often$", "Frequency of the stages"),
    (r"^what it rests on$", "Assumptions"),
    (r"^where answers could differ$", "Determinism"),
    (r"^the declaration decides once$", "Type selection by the declaration"),
    (r"^the tree is the table$", "Storage in the tree"),
    (r"^small questions$", "Small queries"),
    (r"^add a question$", "Add a query"),
    (r"^what every node has$", "Node header"),
    (r"^how a change lands$", "Submitting a change"),
    (r"^(?:who|whom|what|how|where|when|why)\b.*[^?]$", "name the subject: Pitfalls, Cost estimates, Corruption detection"),
]]
