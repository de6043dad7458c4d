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
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(2)
var<storage, read_write> global_3: type_15;
fn function_() {
var phi_103_: u32;
var phi_139_: u32;
var phi_140_: u32;
var phi_141_: u32;
var local: u32;
var local_1: u32;
var local_2: u32;
var local_3: u32;
var local_4: u32;
var local_5: u32;
var phi_174_: u32;
var phi_175_: u32;
var phi_176_: u32;
var local_6: u32;
var phi_193_: i32;
var phi_196_: f32;
var phi_198_: type_5;
var phi_213_: i32;
var phi_216_: f32;
var phi_218_: type_5;
var phi_214_: i32;
var phi_217_: f32;
var phi_219_: type_5;
var phi_194_: i32;
var phi_197_: f32;
var phi_199_: type_5;
var local_7: f32;
var local_8: f32;
var local_9: type_5;
var local_10: type_5;
var local_11: type_5;
var local_12: u32;
var local_13: f32;
var local_14: type_5;
let _e18 = global;
let _e23 = global_1.member.member;
if (_e18.x < _e23.member) {
if (_e18.y < _e23.member_1) {
let _e30 = (_e23.member * _e23.member_1);
let _e32 = ((_e18.y * _e23.member) + _e18.x);
phi_103_ = 1u;
loop {
let _e34 = phi_103_;
local = _e34;
local_1 = _e34;
local_2 = _e34;
local_3 = _e34;
local_6 = _e34;
let _e38 = global_1.member.member_18.member_1;
let _e40 = (_e34 + 1u);
let _e44 = global_1.member.member_18.member_6;
let _e48 = global_1.member.member_18.member_7;
let _e52 = global_1.member.member_18.member_8;
local_4 = _e48;
local_5 = _e52;
local_12 = _e44;
if (_e40 == 0u) {
phi_141_ = 0u;
} else {
if (_e40 == 1u) {
phi_140_ = 0u;
} else {
if (_e40 == 2u) {
phi_139_ = _e44;
} else {
phi_139_ = select(_e52, _e48, (_e40 == 3u));
}
let _e59 = phi_139_;
phi_140_ = _e59;
}
let _e61 = phi_140_;
phi_141_ = _e61;
}
let _e63 = phi_141_;
let _e65 = ((_e34 < _e38) && (_e18.y >= _e63));
continue;
continuing {
phi_103_ = select(u32(), _e40, _e65);
break if !(_e65);
}
}
let _e69 = local;
if (_e69 == 0u) {
phi_176_ = 0u;
} else {
let _e72 = local_1;
if (_e72 == 1u) {
phi_175_ = 0u;
} else {
let _e75 = local_2;
if (_e75 == 2u) {
let _e220 = local_12;
phi_174_ = _e220;
} else {
let _e78 = local_3;
let _e81 = local_4;
let _e83 = local_5;
phi_174_ = select(_e83, _e81, (_e78 == 3u));
}
let _e86 = phi_174_;
phi_175_ = _e86;
}
let _e88 = phi_175_;
phi_176_ = _e88;
}
let _e90 = phi_176_;
let _e92 = bitcast<i32>((_e18.y - _e90));
let _e94 = local_6;
let _e97 = (1i << bitcast<u32>((_e94 & 31u)));
let _e101 = global_1.member.member_1.member;
let _e102 = bitcast<i32>(_e101);
let _e106 = global_1.member.member_1.member_1;
let _e107 = bitcast<i32>(_e106);
phi_193_ = (_e92 * _e97);
phi_196_ = 0f;
phi_198_ = type_5(1e30f, 0f, 0f);
loop {
let _e111 = phi_193_;
let _e113 = phi_196_;
let _e115 = phi_198_;
local_7 = _e113;
local_8 = _e113;
local_9 = _e115;
local_10 = _e115;
local_11 = _e115;
let _e120 = ((_e111 < ((_e92 + 1i) * _e97)) && (_e111 < _e107));
if _e120 {
let _e121 = bitcast<i32>(_e18.x);
phi_213_ = (_e121 * _e97);
phi_216_ = _e113;
phi_218_ = _e115;
loop {
let _e124 = phi_213_;
let _e126 = phi_216_;
let _e128 = phi_218_;
local_13 = _e126;
local_14 = _e128;
let _e133 = ((_e124 < ((_e121 + 1i) * _e97)) && (_e124 < _e102));
if _e133 {
let _e134 = (_e111 * _e102);
let _e135 = (_e134 + _e124);
let _e137 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e139 = select(_e137, _e135, (_e135 < _e137));
let _e145 = global_2.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e153 = (((_e102 * _e107) + _e134) + _e124);
let _e155 = select(_e137, _e153, (_e153 < _e137));
let _e161 = global_2.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
phi_214_ = (_e124 + 1i);
phi_217_ = (_e126 + 1f);
phi_219_ = type_5(select(_e145, _e128.member, (_e128.member < _e145)), select(_e145, _e128.member_1, (_e128.member_1 > _e145)), (_e128.member_2 + _e161));
} else {
phi_214_ = i32();
phi_217_ = f32();
phi_219_ = type_5();
}
let _e168 = phi_214_;
let _e170 = phi_217_;
let _e172 = phi_219_;
continue;
continuing {
phi_213_ = _e168;
phi_216_ = _e170;
phi_218_ = _e172;
break if !(_e133);
}
}
phi_194_ = (_e111 + 1i);
let _e236 = local_13;
phi_197_ = _e236;
let _e239 = local_14;
phi_199_ = _e239;
} else {
phi_194_ = i32();
phi_197_ = f32();
phi_199_ = type_5();
}
let _e176 = phi_194_;
let _e178 = phi_197_;
let _e180 = phi_199_;
continue;
continuing {
phi_193_ = _e176;
phi_196_ = _e178;
phi_198_ = _e180;
break if !(_e120);
}
}
let _e183 = local_7;
let _e186 = local_8;
let _e190 = local_9;
let _e194 = local_10;
let _e197 = local_11;
global_3.member[_e32] = _e194.member;
global_3.member[(_e30 + _e32)] = _e197.member_1;
global_3.member[((2u * _e30) + _e32)] = (_e190.member_2 * (1f / select(1f, _e186, (_e183 > 1f))));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
