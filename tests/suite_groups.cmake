# Which suites of the GoogleTest program share an entry of ctest, and with it the solutions and sheets of the examples
# (support/solved.hpp, support/laid_out.hpp), and which run under sanitizers. Names are regular expressions.

set(suites_of_sheets "Sheet.*|Lying/OverlapOnPaper|Bands|Theme|FigureOne|Brief|.*DataStatement")
set(suites_of_steps_and_upright "Upright/OverlapOnPaper|Examples/Steps|Steps.*|Handouts")
set(suites_of_figures "MechanismFigure|OnMechanism|Labels|Polygon.*|.*FigureAlone.*|.*LoadedExample.*|Symbols|CircleDiagram")
set(suites_of_commands "CommandLine|Batch.*|Sweep.*|SolveAt|.*Command|SameBytes|TexFiles|LiveFiles|QuizFiles|HandoutLine|AnswersLine|.*Commands|MotionOnTheCommandLine")
set(kinegraph_suite_groups sheets steps_and_upright figures commands)

# Under sanitizers: what reads files and texts, solves and lays out. `tests/run --sanitize --all` takes the others too.
set(kinegraph_sanitized_suites
    Reader JsonSource Gate Formula Parameters Units Decimals Exact Root Found/.* ".*/Found" Pose Positions Mobility Branches
    Cam Program Forces Derivative Trusses Equations.* EquationsAsJson NamedResults Variants Cycle Workings Examples
    ForceLaws ForceExamples HigherPairs Hertz Impact PointMotion VirtualWork ".*Superposed" RandomChains1 RandomMechanisms1
    RandomForces1 RoundedDegenerateMechanisms Sheet "Sheet/EveryExample" "Lying/OverlapOnPaper" Handouts "Examples/Steps" RandomPages1
    Svg Backends Png Pdf Picture Markup LiveText Tex Type Utf8 DiffCommand QuizOf)
list(JOIN kinegraph_sanitized_suites "|" kinegraph_sanitized_suites)

# These cannot run under sanitizers, which hold on to what is freed to see whether it is used again: memory grows.
set(kinegraph_unsanitized_suites "BatchMemory")
