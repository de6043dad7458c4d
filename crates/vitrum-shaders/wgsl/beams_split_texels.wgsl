struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_17 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_20 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_21 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_22 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_20,
member_19: type_21,
}
struct type_23 {
member: type_22,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_23;
@group(0) @binding(2)
var<storage> global_2: type_15;
@group(0) @binding(1)
var<storage> global_3: type_15;
@group(0) @binding(3)
var<storage, read_write> global_4: type_15;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var phi_182_: i32;
var phi_214_: i32;
var phi_247_: i32;
let _e57 = global;
let _e65 = global_1.member.member;
if (_e57.x < _e65.member) {
if (_e57.y < _e65.member_1) {
let _e72 = (_e65.member * _e65.member_1);
let _e74 = ((_e57.y * _e65.member) + _e57.x);
let _e78 = global_1.member.member.member;
let _e81 = bitcast<i32>((_e78 >> bitcast<u32>(1i)));
let _e85 = global_1.member.member.member_1;
let _e88 = bitcast<i32>((_e85 >> bitcast<u32>(1i)));
let _e91 = bitcast<i32>((_e57.x >> bitcast<u32>(1i)));
let _e94 = bitcast<i32>((_e57.y >> bitcast<u32>(1i)));
let _e99 = ((_e91 + (2i * bitcast<i32>((_e57.x & 1u)))) - 1i);
let _e104 = ((_e94 + (2i * bitcast<i32>((_e57.y & 1u)))) - 1i);
let _e107 = ((_e99 >= 0i) && (_e99 < _e81));
let _e108 = (_e94 >= 0i);
let _e110 = (_e94 < _e88);
let _e111 = ((_e107 && _e108) && _e110);
if _e111 {
phi_182_ = ((_e94 * _e81) + _e99);
} else {
phi_182_ = 0i;
}
let _e115 = phi_182_;
let _e117 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e119 = select(_e117, _e115, (_e115 < _e117));
let _e125 = global_3.member[bitcast<u32>(select(0i, _e119, (_e119 > 0i)))];
let _e130 = ((_e91 >= 0i) && (_e91 < _e81));
let _e131 = (_e104 >= 0i);
let _e133 = (_e104 < _e88);
let _e134 = ((_e130 && _e131) && _e133);
if _e134 {
phi_214_ = ((_e104 * _e81) + _e91);
} else {
phi_214_ = 0i;
}
let _e138 = phi_214_;
let _e140 = select(_e117, _e138, (_e138 < _e117));
let _e146 = global_3.member[bitcast<u32>(select(0i, _e140, (_e140 > 0i)))];
let _e151 = ((_e107 && _e131) && _e133);
if _e151 {
phi_247_ = ((_e104 * _e81) + _e99);
} else {
phi_247_ = 0i;
}
let _e155 = phi_247_;
let _e157 = select(_e117, _e155, (_e155 < _e117));
let _e163 = global_3.member[bitcast<u32>(select(0i, _e157, (_e157 > 0i)))];
let _e168 = ((_e94 * _e81) + _e91);
local = 0i;
local_1 = _e168;
local_2 = (_e81 * _e88);
let _e170 = local;
let _e171 = local_2;
let _e174 = local_1;
let _e175 = ((_e170 + (18i * _e171)) + _e174);
let _e177 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e179 = select(_e177, _e175, (_e175 < _e177));
let _e184 = global_2.member[bitcast<u32>(select(0i, _e179, (_e179 > 0i)))];
let _e185 = local;
let _e186 = local_2;
let _e189 = local_1;
let _e190 = ((_e185 + (19i * _e186)) + _e189);
let _e192 = select(_e177, _e190, (_e190 < _e177));
let _e197 = global_2.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e199 = local;
let _e200 = local_2;
let _e203 = local_1;
let _e204 = ((_e199 + (20i * _e200)) + _e203);
let _e206 = select(_e177, _e204, (_e204 < _e177));
let _e211 = global_2.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e216 = ((_e130 && _e108) && _e110);
let _e217 = select(0i, _e168, _e216);
let _e219 = select(_e117, _e217, (_e217 < _e117));
let _e225 = global_3.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
global_4.member[_e74] = 0f;
global_4.member[(_e72 + _e74)] = 0f;
global_4.member[((2u * _e72) + _e74)] = 0f;
global_4.member[((3u * _e72) + _e74)] = 0f;
global_4.member[((4u * _e72) + _e74)] = 0f;
global_4.member[((5u * _e72) + _e74)] = 0f;
global_4.member[((6u * _e72) + _e74)] = 0f;
global_4.member[((7u * _e72) + _e74)] = 0f;
global_4.member[((8u * _e72) + _e74)] = 0f;
global_4.member[((9u * _e72) + _e74)] = 0f;
global_4.member[((10u * _e72) + _e74)] = 0f;
global_4.member[((11u * _e72) + _e74)] = 0f;
global_4.member[((12u * _e72) + _e74)] = 0f;
global_4.member[((13u * _e72) + _e74)] = 0f;
global_4.member[((14u * _e72) + _e74)] = 0f;
global_4.member[((15u * _e72) + _e74)] = 0f;
global_4.member[((16u * _e72) + _e74)] = 0f;
global_4.member[((17u * _e72) + _e74)] = 0f;
global_4.member[((18u * _e72) + _e74)] = 0f;
global_4.member[((19u * _e72) + _e74)] = 0f;
global_4.member[((20u * _e72) + _e74)] = 0f;
global_4.member[((21u * _e72) + _e74)] = 0f;
global_4.member[((22u * _e72) + _e74)] = 0f;
global_4.member[((23u * _e72) + _e74)] = 0f;
global_4.member[((24u * _e72) + _e74)] = 0f;
global_4.member[((25u * _e72) + _e74)] = 0f;
global_4.member[((26u * _e72) + _e74)] = 0f;
global_4.member[((27u * _e72) + _e74)] = 0f;
global_4.member[((28u * _e72) + _e74)] = 0f;
global_4.member[((29u * _e72) + _e74)] = select(3f, 0f, ((_e216 && (_e225 > 0f)) || (!((((_e184 + _e197) + _e211) > 0f)) && (((_e111 && (_e125 > 0f)) || (_e134 && (_e146 > 0f))) || (_e151 && (_e163 > 0f))))));
global_4.member[((30u * _e72) + _e74)] = 0f;
global_4.member[((31u * _e72) + _e74)] = 0f;
global_4.member[((32u * _e72) + _e74)] = 0f;
global_4.member[((33u * _e72) + _e74)] = 0f;
global_4.member[((34u * _e72) + _e74)] = 0f;
global_4.member[((35u * _e72) + _e74)] = 0f;
global_4.member[((36u * _e72) + _e74)] = 0f;
global_4.member[((37u * _e72) + _e74)] = 0f;
global_4.member[((38u * _e72) + _e74)] = 0f;
global_4.member[((39u * _e72) + _e74)] = 0f;
global_4.member[((40u * _e72) + _e74)] = 0f;
global_4.member[((41u * _e72) + _e74)] = 0f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
