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
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_15 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_16 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_17 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_14,
member_18: type_15,
member_19: type_5,
member_20: type_16,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_18 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_12,
member_21: type_13,
member_22: type_17,
}
struct type_19 {
member: type_18,
}
struct type_21 {
member: array<f32>,
}
struct type_24 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_19;
@group(0) @binding(1)
var<storage, read_write> global_2: type_21;
fn function_() {
var phi_855_: vec3<f32>;
var phi_863_: vec3<f32>;
var phi_1203_: type_24;
let _e60 = global;
let _e65 = global_1.member.member;
if (_e60.x < _e65.member) {
if (_e60.y < _e65.member_1) {
let _e72 = (_e65.member * _e65.member_1);
let _e74 = ((_e60.y * _e65.member) + _e60.x);
let _e75 = bitcast<i32>(_e74);
let _e77 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e79 = select(_e77, _e75, (_e75 < _e77));
let _e85 = global_2.member[bitcast<u32>(select(0i, _e79, (_e79 > 0i)))];
let _e86 = (_e72 + _e74);
let _e87 = bitcast<i32>(_e86);
let _e89 = select(_e77, _e87, (_e87 < _e77));
let _e95 = global_2.member[bitcast<u32>(select(0i, _e89, (_e89 > 0i)))];
let _e97 = ((2u * _e72) + _e74);
let _e98 = bitcast<i32>(_e97);
let _e100 = select(_e77, _e98, (_e98 < _e77));
let _e106 = global_2.member[bitcast<u32>(select(0i, _e100, (_e100 > 0i)))];
let _e108 = ((3u * _e72) + _e74);
let _e109 = bitcast<i32>(_e108);
let _e111 = select(_e77, _e109, (_e109 < _e77));
let _e117 = global_2.member[bitcast<u32>(select(0i, _e111, (_e111 > 0i)))];
let _e119 = ((4u * _e72) + _e74);
let _e120 = bitcast<i32>(_e119);
let _e122 = select(_e77, _e120, (_e120 < _e77));
let _e128 = global_2.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e130 = ((5u * _e72) + _e74);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e77, _e131, (_e131 < _e77));
let _e139 = global_2.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((9u * _e72) + _e74);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e77, _e142, (_e142 < _e77));
let _e150 = global_2.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((10u * _e72) + _e74);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e77, _e153, (_e153 < _e77));
let _e161 = global_2.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((11u * _e72) + _e74);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e77, _e164, (_e164 < _e77));
let _e172 = global_2.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((12u * _e72) + _e74);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e77, _e175, (_e175 < _e77));
let _e183 = global_2.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((13u * _e72) + _e74);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e77, _e186, (_e186 < _e77));
let _e194 = global_2.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((14u * _e72) + _e74);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e77, _e197, (_e197 < _e77));
let _e205 = global_2.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((15u * _e72) + _e74);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e77, _e208, (_e208 < _e77));
let _e216 = global_2.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((17u * _e72) + _e74);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e77, _e219, (_e219 < _e77));
let _e227 = global_2.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((19u * _e72) + _e74);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e77, _e230, (_e230 < _e77));
let _e238 = global_2.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e240 = ((20u * _e72) + _e74);
let _e241 = bitcast<i32>(_e240);
let _e243 = select(_e77, _e241, (_e241 < _e77));
let _e249 = global_2.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e251 = ((21u * _e72) + _e74);
let _e252 = bitcast<i32>(_e251);
let _e254 = select(_e77, _e252, (_e252 < _e77));
let _e260 = global_2.member[bitcast<u32>(select(0i, _e254, (_e254 > 0i)))];
let _e262 = ((25u * _e72) + _e74);
let _e263 = bitcast<i32>(_e262);
let _e265 = select(_e77, _e263, (_e263 < _e77));
let _e271 = global_2.member[bitcast<u32>(select(0i, _e265, (_e265 > 0i)))];
let _e273 = ((26u * _e72) + _e74);
let _e274 = bitcast<i32>(_e273);
let _e276 = select(_e77, _e274, (_e274 < _e77));
let _e282 = global_2.member[bitcast<u32>(select(0i, _e276, (_e276 > 0i)))];
let _e284 = ((27u * _e72) + _e74);
let _e285 = bitcast<i32>(_e284);
let _e287 = select(_e77, _e285, (_e285 < _e77));
let _e293 = global_2.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e295 = ((28u * _e72) + _e74);
let _e296 = bitcast<i32>(_e295);
let _e298 = select(_e77, _e296, (_e296 < _e77));
let _e304 = global_2.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e306 = ((29u * _e72) + _e74);
let _e307 = bitcast<i32>(_e306);
let _e309 = select(_e77, _e307, (_e307 < _e77));
let _e315 = global_2.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e317 = ((30u * _e72) + _e74);
let _e318 = bitcast<i32>(_e317);
let _e320 = select(_e77, _e318, (_e318 < _e77));
let _e326 = global_2.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e328 = ((31u * _e72) + _e74);
let _e329 = bitcast<i32>(_e328);
let _e331 = select(_e77, _e329, (_e329 < _e77));
let _e337 = global_2.member[bitcast<u32>(select(0i, _e331, (_e331 > 0i)))];
let _e356 = select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < -2147483600f)), 2147483647i, (_e304 > 2147483500f)), (_e304 == _e304));
if (((_e271 + _e282) + _e293) > 0f) {
let _e378 = global_1.member.member.member;
let _e384 = global_1.member.member.member_1;
let _e396 = global_1.member.member_6.member;
let _e397 = (((((f32(bitcast<i32>(_e60.x)) + 0.5f) / f32(bitcast<i32>(_e378))) * 2f) - 1f) * _e396);
let _e407 = global_1.member.member_6.member_1;
let _e408 = ((1f - (((f32(bitcast<i32>(_e60.y)) + 0.5f) / f32(bitcast<i32>(_e384))) * 2f)) * _e407);
let _e411 = global_1.member.member_10;
let _e418 = global_1.member.member_7;
let _e427 = global_1.member.member_8;
let _e434 = ((_e418.member * _e397) + (_e427.member * _e408));
let _e435 = ((_e418.member_1 * _e397) + (_e427.member_1 * _e408));
let _e436 = ((_e418.member_2 * _e397) + (_e427.member_2 * _e408));
let _e440 = global_1.member.member_6.member_3;
let _e441 = (_e440 != 0u);
if _e441 {
let _e454 = global_1.member.member_9;
phi_855_ = vec3<f32>(_e454.member, _e454.member_1, _e454.member_2);
} else {
let _e444 = global_1.member.member_9;
phi_855_ = vec3<f32>((_e444.member + _e434), (_e444.member_1 + _e435), (_e444.member_2 + _e436));
}
let _e460 = phi_855_;
if _e441 {
phi_863_ = vec3<f32>((_e411.member + _e434), (_e411.member_1 + _e435), (_e411.member_2 + _e436));
} else {
phi_863_ = vec3<f32>(_e411.member, _e411.member_1, _e411.member_2);
}
let _e466 = phi_863_;
let _e474 = (((_e460.x * _e460.x) + (_e460.y * _e460.y)) + (_e460.z * _e460.z));
let _e477 = sqrt(select(0f, _e474, (_e474 > 0f)));
let _e480 = (1f / select(1e-20f, _e477, (_e477 > 1e-20f)));
let _e481 = (_e460.x * _e480);
let _e482 = (_e460.y * _e480);
let _e483 = (_e460.z * _e480);
let _e491 = (1f / select(_e481, select(1e-12f, -1e-12f, (_e481 < 0f)), (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) < 1e-12f)));
let _e499 = (1f / select(_e482, select(1e-12f, -1e-12f, (_e482 < 0f)), (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) < 1e-12f)));
let _e507 = (1f / select(_e483, select(1e-12f, -1e-12f, (_e483 < 0f)), (bitcast<f32>((bitcast<u32>(_e483) & 2147483647u)) < 1e-12f)));
let _e510 = global_1.member.member_14;
let _e516 = global_1.member.member_15;
let _e522 = ((_e510.member - _e466.x) * _e491);
let _e524 = ((_e516.member - _e466.x) * _e491);
let _e527 = ((_e510.member_1 - _e466.y) * _e499);
let _e529 = ((_e516.member_1 - _e466.y) * _e499);
let _e532 = ((_e510.member_2 - _e466.z) * _e507);
let _e534 = ((_e516.member_2 - _e466.z) * _e507);
let _e536 = select(_e524, _e522, (_e522 < _e524));
let _e538 = select(_e529, _e527, (_e527 < _e529));
let _e540 = select(_e538, _e536, (_e536 > _e538));
let _e542 = select(_e534, _e532, (_e532 < _e534));
let _e544 = select(_e542, _e540, (_e540 > _e542));
let _e546 = select(_e524, _e522, (_e522 > _e524));
let _e548 = select(_e529, _e527, (_e527 > _e529));
let _e550 = select(_e548, _e546, (_e546 < _e548));
let _e552 = select(_e534, _e532, (_e532 > _e534));
let _e554 = select(_e552, _e550, (_e550 < _e552));
let _e559 = global_1.member.member_18.member.member;
let _e570 = ((((_e559.member.member * _e466.x) + (_e559.member.member_1 * _e466.y)) + (_e559.member.member_2 * _e466.z)) + _e559.member_1);
let _e576 = -((((_e559.member.member * _e481) + (_e559.member.member_1 * _e482)) + (_e559.member.member_2 * _e483)));
let _e578 = (_e576 > 1e-9f);
let _e582 = ((_e570 / select(1e-9f, _e576, _e578)) - 0.015625f);
let _e585 = select(1e30f, select(0f, _e582, (_e582 > 0f)), ((_e570 > 0f) && _e578));
let _e590 = global_1.member.member_18.member_1.member;
let _e601 = ((((_e590.member.member * _e466.x) + (_e590.member.member_1 * _e466.y)) + (_e590.member.member_2 * _e466.z)) + _e590.member_1);
let _e607 = -((((_e590.member.member * _e481) + (_e590.member.member_1 * _e482)) + (_e590.member.member_2 * _e483)));
let _e609 = (_e607 > 1e-9f);
let _e613 = ((_e601 / select(1e-9f, _e607, _e609)) - 0.015625f);
let _e616 = select(1e30f, select(0f, _e613, (_e613 > 0f)), ((_e601 > 0f) && _e609));
let _e620 = (_e616 < _e585);
let _e622 = select(select(-2i, -3i, _e620), -1i, ((_e585 >= 1e30f) && (_e616 >= 1e30f)));
let _e623 = select(_e585, _e616, _e620);
let _e625 = select(0f, _e544, (_e544 > 0f));
let _e626 = (_e622 != -1i);
let _e632 = (((_e554 <= _e544) || (_e554 <= 0f)) || (_e626 && (_e623 <= _e625)));
let _e634 = select(_e625, select(0f, _e623, _e626), _e632);
let _e637 = global_1.member.member_1;
let _e647 = f32(_e622);
phi_1203_ = type_24((_e466 + vec3<f32>((_e481 * _e634), (_e482 * _e634), (_e483 * _e634))), (_e460 * _e480), vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 1e9f, select(select(0f, 4f, ((_e637 & 2u) != 0u)), select(1f, 3f, _e626), _e632), 16i, 0f, 0f, _e634, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), _e356, 0i, select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < -2147483600f)), 2147483647i, (_e647 > 2147483500f)), (_e647 == _e647)), (_e623 - _e634));
} else {
phi_1203_ = type_24(vec3<f32>(_e85, _e95, _e106), vec3<f32>(_e117, _e128, _e139), vec3<f32>(0f, 0f, 0f), vec3<f32>(_e150, _e161, _e172), vec3<f32>(_e183, _e194, _e205), _e216, 1f, select(0i, select(select(i32(_e227), i32(-2147483648), (_e227 < -2147483600f)), 2147483647i, (_e227 > 2147483500f)), (_e227 == _e227)), 0f, _e238, _e249, _e260, vec3<f32>(0f, 0f, 0f), vec3<f32>(_e271, _e282, _e293), _e356, select(0i, select(select(i32(_e315), i32(-2147483648), (_e315 < -2147483600f)), 2147483647i, (_e315 > 2147483500f)), (_e315 == _e315)), select(0i, select(select(i32(_e326), i32(-2147483648), (_e326 < -2147483600f)), 2147483647i, (_e326 > 2147483500f)), (_e326 == _e326)), _e337);
}
let _e660 = phi_1203_;
global_2.member[_e74] = _e660.member.x;
global_2.member[_e86] = _e660.member.y;
global_2.member[_e97] = _e660.member.z;
global_2.member[_e108] = _e660.member_1.x;
global_2.member[_e119] = _e660.member_1.y;
global_2.member[_e130] = _e660.member_1.z;
global_2.member[((6u * _e72) + _e74)] = _e660.member_2.x;
global_2.member[((7u * _e72) + _e74)] = _e660.member_2.y;
global_2.member[((8u * _e72) + _e74)] = _e660.member_2.z;
global_2.member[_e141] = _e660.member_3.x;
global_2.member[_e152] = _e660.member_3.y;
global_2.member[_e163] = _e660.member_3.z;
global_2.member[_e174] = _e660.member_4.x;
global_2.member[_e185] = _e660.member_4.y;
global_2.member[_e196] = _e660.member_4.z;
global_2.member[_e207] = _e660.member_5;
global_2.member[((16u * _e72) + _e74)] = _e660.member_6;
global_2.member[_e218] = f32(_e660.member_7);
global_2.member[((18u * _e72) + _e74)] = _e660.member_8;
global_2.member[_e229] = _e660.member_9;
global_2.member[_e240] = _e660.member_10;
global_2.member[_e251] = _e660.member_11;
global_2.member[((22u * _e72) + _e74)] = _e660.member_12.x;
global_2.member[((23u * _e72) + _e74)] = _e660.member_12.y;
global_2.member[((24u * _e72) + _e74)] = _e660.member_12.z;
global_2.member[_e262] = _e660.member_13.x;
global_2.member[_e273] = _e660.member_13.y;
global_2.member[_e284] = _e660.member_13.z;
global_2.member[_e295] = f32(_e660.member_14);
global_2.member[_e306] = f32(_e660.member_15);
global_2.member[_e317] = f32(_e660.member_16);
global_2.member[_e328] = _e660.member_17;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
