// The digital side of the sweeps of a frame, tick by tick: ramps that meet their stops, pointers of the four colours, a queue before each
// bank, words on their way, registers. One unit for the fine level and one for the coarse level.
//
// What each does is the law of docs/blocks/dpu.md with wired pointers, a set of nine words an access, urgent sets first, no diagonal
// register, and late words strobed through.

/// One unit: the folds of one level, and who answers them.
module crossing_service #(
    parameter int POINTER = 2,
    parameter int ACCESS = 2,
    parameter int STROBE = 1
) (
    input logic clk,
    /// Loads what the set-up of a sweep is; no tick of the sweep.
    input logic begin_sweep,
    /// Ticks since the sweep began.
    input int tick,
    /// Ground range at this tick; 24 bits of metres and 40 below.
    input logic [63:0] range,
    /// Ground range of the next fold of each axis, and from one fold to the next; all ones for a ramp that stands.
    input logic [63:0] first_x, first_y, step_x, step_y,
    /// Ground range at which the profile ends.
    input logic [63:0] end_range,
    /// Whether the first fold of an axis is at its stop at one.
    input logic one_x, one_y,
    /// The start region, and two corners along each axis of the way.
    input int region_x, region_y, way_x, way_y,
    /// The last corner line of each axis.
    input int last_x, last_y,
    output int folds, wanted, served, loads, late, corners, held, longest
);
    typedef struct packed {
        logic is_y;
        logic is_late;
        logic is_urgent;
        logic [15:0] corner;
    } job_t;

    typedef struct packed {
        logic is_there;
        logic is_y;
        logic is_late;
        logic [15:0] corner;
        logic [15:0] comes;
    } flight_t;

    logic [63:0] next_x, next_y;
    logic stop_x, stop_y, moves_x, moves_y;
    /// Of each axis the even and the odd line on which colours stand.
    int line_x[2], line_y[2];
    /// What waits before the bank of each colour, first asked first, and how many.
    job_t queue[4][4];
    int waiting[4];
    int free_at[4];
    /// A set on its way, and one whose strobe overlaps with the next.
    flight_t flight[4][2];
    /// Corners in the registers of each colour.
    logic [15:0] hold[4], preload_x[4], preload_y[4];
    /// Sets that wait or are on their way.
    int at_work;

    function automatic logic [15:0] corner_at(input int m, input int n);
        int x, y;
        x = m < 0 ? 0 : m > last_x ? last_x : m;
        y = n < 0 ? 0 : n > last_y ? last_y : n;
        corner_at = 16'(x * (last_y + 1) + y);
    endfunction

    /// Asks for a set of a colour.
    task automatic ask(input int colour, input logic is_y, input logic is_urgent);
        int m, n;
        m = line_x[colour & 1] + (is_y ? 0 : way_x);
        n = line_y[colour >> 1] + (is_y ? way_y : 0);
        queue[colour][waiting[colour]] = '{is_y, 1'b0, is_urgent, corner_at(m, n)};
        waiting[colour] = waiting[colour] + 1;
        if (waiting[colour] > longest) longest = waiting[colour];
        at_work = at_work + 1;
        wanted = wanted + 1;
    endtask

    /// A colour takes its register of an axis: what has not come is late, what is for the other register is dropped.
    task automatic take(input int colour, input logic of_y);
        int kept;
        job_t job;
        hold[colour] = of_y ? preload_y[colour] : preload_x[colour];
        held = held + 32'(hold[colour]);
        kept = 0;
        for (int place = 0; place < 4; place++) begin
            if (place < waiting[colour]) begin
                job = queue[colour][place];
                if (job.is_y == of_y && !job.is_late) begin
                    late = late + 1;
                    job.is_late = 1'b1;
                    queue[colour][kept] = job;
                    kept = kept + 1;
                end else begin
                    at_work = at_work - 1;
                end
            end
        end
        waiting[colour] = kept;
        for (int slot = 0; slot < 2; slot++) begin
            if (flight[colour][slot].is_there) begin
                if (flight[colour][slot].is_y == of_y && !flight[colour][slot].is_late) begin
                    late = late + 1;
                    flight[colour][slot].is_late = 1'b1;
                end else begin
                    at_work = at_work - 1;
                    flight[colour][slot].is_there = 1'b0;
                end
            end
        end
    endtask

    /// A fold: two colours take their register, move, and ask for both registers anew.
    task automatic fold(input logic is_y);
        logic at_one;
        int first, second, line, colour;
        logic urgent_x, urgent_y;
        at_one = is_y ? stop_y : stop_x;
        if (is_y) begin
            stop_y = !stop_y;
            next_y = next_y + step_y;
        end else begin
            stop_x = !stop_x;
            next_x = next_x + step_x;
        end
        first = at_one ? 0 : is_y ? 2 : 1;
        second = first + (is_y ? 1 : 2);
        line = at_one ? 0 : 1;
        take(first, is_y);
        take(second, is_y);
        if (is_y) line_y[line] = line_y[line] + way_y;
        else line_x[line] = line_x[line] + way_x;
        for (int turn = 0; turn < 2; turn++) begin
            colour = turn == 0 ? first : second;
            // The next stop of the other axis takes a colour at its far end if that stop is at zero.
            urgent_x = is_y && moves_x && (colour[0] == !stop_x);
            urgent_y = !is_y && moves_y && (colour[1] == !stop_y);
            ask(colour, 1'b0, urgent_x);
            ask(colour, 1'b1, urgent_y);
        end
        folds = folds + 1;
    endtask

    /// The bank of a colour begins with the next set, if it is free.
    task automatic serve(input int colour);
        int chosen, slot;
        job_t job;
        if (waiting[colour] != 0 && free_at[colour] <= tick) begin
            chosen = 0;
            for (int place = 3; place >= 0; place--)
                if (place < waiting[colour] && queue[colour][place].is_urgent) chosen = place;
            job = queue[colour][chosen];
            for (int place = 0; place < 3; place++)
                if (place >= chosen) queue[colour][place] = queue[colour][place + 1];
            waiting[colour] = waiting[colour] - 1;
            free_at[colour] = tick + POINTER + ACCESS;
            slot = flight[colour][0].is_there ? 1 : 0;
            flight[colour][slot] =
                '{1'b1, job.is_y, job.is_late, job.corner, 16'(tick + POINTER + ACCESS + STROBE)};
            served = served + 1;
        end
    endtask

    /// Words that come at this tick go to their register.
    task automatic deliver(input int colour);
        for (int slot = 0; slot < 2; slot++) begin
            if (flight[colour][slot].is_there && flight[colour][slot].comes == tick[15:0]) begin
                if (flight[colour][slot].is_late) hold[colour] = flight[colour][slot].corner;
                else if (flight[colour][slot].is_y) preload_y[colour] = flight[colour][slot].corner;
                else preload_x[colour] = flight[colour][slot].corner;
                flight[colour][slot].is_there = 1'b0;
                at_work = at_work - 1;
                if (range <= end_range) begin
                    loads = loads + 1;
                    corners = corners + 32'(flight[colour][slot].corner);
                end
            end
        end
    endtask

    /// Full registers and an empty queue.
    task automatic set_up;
        int m, n;
        next_x = first_x;
        next_y = first_y;
        stop_x = one_x;
        stop_y = one_y;
        moves_x = !(&first_x);
        moves_y = !(&first_y);
        line_x[0] = region_x + (region_x & 1);
        line_x[1] = region_x + 1 - (region_x & 1);
        line_y[0] = region_y + (region_y & 1);
        line_y[1] = region_y + 1 - (region_y & 1);
        at_work = 0;
        for (int colour = 0; colour < 4; colour++) begin
            m = line_x[colour & 1];
            n = line_y[colour >> 1];
            hold[colour] = corner_at(m, n);
            preload_x[colour] = corner_at(m + way_x, n);
            preload_y[colour] = corner_at(m, n + way_y);
            waiting[colour] = 0;
            free_at[colour] = 0;
            flight[colour][0].is_there = 1'b0;
            flight[colour][1].is_there = 1'b0;
        end
    endtask

    // Blocking assignments: what a tick does, it does in order, and nothing else reads it within the tick.
    always_ff @(posedge clk) begin
        if (begin_sweep) begin
            set_up();
        end else begin
            // Both axes may fold within a tick: the nearer one first, X before Y.
            for (int turn = 0; turn < 2; turn++) begin
                if (next_x <= next_y) begin
                    if (next_x <= range && next_x <= end_range) fold(1'b0);
                end else begin
                    if (next_y <= range && next_y <= end_range) fold(1'b1);
                end
            end
            if (at_work != 0) begin
                for (int colour = 0; colour < 4; colour++) begin
                    serve(colour);
                    deliver(colour);
                end
            end
        end
    end
endmodule

/// Both units, and the ground range of each tick, which they share.
module control_plane #(
    /// Sweeps after which the ticks of a sweep fall alike again, and ticks of a sweep, a power of two.
    parameter int PHASES = 63,
    parameter int TICKS = 2048,
    parameter int POINTER = 2,
    parameter int ACCESS = 2,
    parameter int STROBE = 1
) (
    input logic clk,
    input logic begin_sweep,
    /// Which of the phases a sweep has.
    input int phase,
    input logic [63:0] first_x[2], first_y[2], step_x[2], step_y[2], end_range[2],
    input logic one_x[2], one_y[2],
    input int region_x[2], region_y[2], way_x, way_y, last_x[2], last_y[2],
    output int folds[2], wanted[2], served[2], loads[2], late[2], corners[2], held[2], longest[2]
);
    /// Ground range of each tick of each phase.
    logic [63:0] ranges[PHASES * TICKS];
    initial $readmemh("ranges.hex", ranges);

    int tick, place;
    logic [63:0] range;
    assign range = ranges[place];

    always_ff @(posedge clk) begin
        if (begin_sweep) begin
            tick <= 0;
            place <= phase * TICKS;
        end else begin
            tick <= tick + 1;
            place <= place + 1;
        end
    end

    for (genvar level = 0; level < 2; level++) begin : levels
        crossing_service #(.POINTER(POINTER), .ACCESS(ACCESS), .STROBE(STROBE)) service (
            .clk, .begin_sweep, .tick, .range,
            .first_x(first_x[level]), .first_y(first_y[level]), .step_x(step_x[level]), .step_y(step_y[level]),
            .end_range(end_range[level]), .one_x(one_x[level]), .one_y(one_y[level]),
            .region_x(region_x[level]), .region_y(region_y[level]), .way_x, .way_y,
            .last_x(last_x[level]), .last_y(last_y[level]),
            .folds(folds[level]), .wanted(wanted[level]), .served(served[level]), .loads(loads[level]),
            .late(late[level]), .corners(corners[level]), .held(held[level]),
            .longest(longest[level])
        );
    end
endmodule
