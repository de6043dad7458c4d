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
struct type_19 {
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
struct type_20 {
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
struct type_21 {
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
struct type_22 {
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
struct type_23 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_24 {
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
member_11: type_19,
member_12: type_20,
member_13: type_21,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_22,
member_19: type_23,
}
struct type_25 {
member: type_24,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: vec3<f32>,
member_7: i32,
member_8: i32,
member_9: i32,
member_10: f32,
member_11: i32,
member_12: i32,
member_13: f32,
member_14: f32,
member_15: f32,
member_16: i32,
member_17: i32,
member_18: i32,
member_19: i32,
member_20: i32,
member_21: i32,
member_22: i32,
member_23: f32,
member_24: f32,
member_25: f32,
member_26: f32,
member_27: f32,
}
struct type_28 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: i32,
}
struct type_29 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(3)
var<storage> global_1: type_15;
@group(0) @binding(4)
var<storage, read_write> global_2: type_15;
@group(0) @binding(0)
var<storage> global_3: type_25;
@group(0) @binding(1)
var<storage> global_4: type_15;
@group(0) @binding(2)
var<storage> global_5: type_15;
var<private> global_6: array<f32, 42> = array<f32, 42>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: f32;
var local_7: i32;
var local_8: f32;
var local_9: i32;
var local_10: f32;
var local_11: i32;
var phi_590_: f32;
var phi_1092_: u32;
var phi_1095_: f32;
var phi_1230_: i32;
var phi_1243_: i32;
var phi_1257_: i32;
var phi_1573_: i32;
var phi_1586_: i32;
var phi_1600_: i32;
var phi_1093_: u32;
var phi_1096_: f32;
var phi_1805_: f32;
var phi_2033_: f32;
var phi_2272_: u32;
var phi_2275_: f32;
var phi_2416_: i32;
var phi_2429_: i32;
var phi_2443_: i32;
var phi_2765_: i32;
var phi_2778_: i32;
var phi_2792_: i32;
var phi_2273_: u32;
var phi_2276_: f32;
var phi_2997_: f32;
var phi_3230_: f32;
var phi_3262_: f32;
var phi_3948_: vec3<f32>;
var phi_3949_: type_27;
var phi_3950_: vec3<f32>;
var phi_3953_: type_27;
var phi_3956_: i32;
var phi_4357_: f32;
var phi_4409_: f32;
var phi_4705_: type_28;
var phi_5203_: f32;
var phi_5255_: f32;
var phi_5551_: type_28;
var phi_5555_: i32;
var phi_5558_: type_29;
var phi_5568_: vec3<f32>;
var phi_5571_: vec3<f32>;
var phi_5573_: i32;
var phi_5575_: f32;
var phi_5953_: f32;
var phi_6005_: f32;
var phi_6301_: type_28;
var phi_6469_: vec3<f32>;
var phi_6470_: vec3<f32>;
var phi_6471_: f32;
var phi_5569_: vec3<f32>;
var phi_5572_: vec3<f32>;
var phi_5574_: i32;
var phi_5576_: f32;
var local_12: f32;
var local_13: f32;
var local_14: vec3<f32>;
var local_15: vec3<f32>;
var local_16: vec3<f32>;
var local_17: vec3<f32>;
var phi_6491_: type_29;
var phi_5556_: i32;
var phi_5559_: type_29;
var local_18: type_29;
var local_19: type_29;
var local_20: type_29;
var local_21: type_29;
var phi_6662_: u32;
var phi_6665_: f32;
var phi_6806_: i32;
var phi_6819_: i32;
var phi_6833_: i32;
var phi_7155_: i32;
var phi_7168_: i32;
var phi_7182_: i32;
var phi_6663_: u32;
var phi_6666_: f32;
var phi_7387_: f32;
var phi_7610_: type_27;
var phi_7611_: type_27;
var phi_7612_: type_27;
var phi_3954_: type_27;
var phi_3957_: i32;
var local_22: type_27;
var local_23: type_27;
var local_24: type_27;
var local_25: type_27;
var local_26: type_27;
var local_27: type_27;
var local_28: type_27;
var local_29: type_27;
var local_30: type_27;
var local_31: type_27;
var local_32: type_27;
var local_33: type_27;
var local_34: type_27;
var local_35: type_27;
var local_36: type_27;
var local_37: type_27;
var local_38: type_27;
var local_39: type_27;
var local_40: type_27;
var local_41: type_27;
var local_42: type_27;
var local_43: type_27;
var local_44: type_27;
var local_45: type_27;
var local_46: type_27;
var local_47: type_27;
var local_48: type_27;
var local_49: type_27;
var local_50: type_27;
var local_51: type_27;
var local_52: type_27;
var local_53: type_27;
var local_54: type_27;
var local_55: type_27;
var local_56: type_27;
var local_57: type_27;
var local_58: type_27;
var local_59: type_27;
var local_60: type_27;
var local_61: type_27;
var local_62: type_27;
var local_63: type_27;
var phi_7669_: array<f32, 42>;
var phi_7670_: array<f32, 42>;
var phi_7671_: array<f32, 42>;
var phi_7672_: array<f32, 42>;
var phi_7673_: bool;
var phi_7677_: array<f32, 42>;
var phi_7678_: array<f32, 42>;
var phi_7679_: bool;
var phi_7683_: array<f32, 42>;
var local_64: f32;
var local_65: f32;
var local_66: f32;
let _e122 = global;
let _e126 = arrayLength((&global_5.member));
let _e129 = arrayLength((&global_1.member));
let _e132 = global_3.member.member;
if (_e122.x < _e132.member) {
if (_e122.y < _e132.member_1) {
let _e139 = (_e132.member * _e132.member_1);
let _e141 = ((_e122.y * _e132.member) + _e122.x);
let _e142 = bitcast<i32>(_e122.x);
let _e143 = bitcast<i32>(_e122.y);
let _e147 = global_3.member.member.member;
let _e151 = global_3.member.member.member_1;
let _e153 = bitcast<i32>((_e147 * _e151));
let _e156 = ((_e143 * bitcast<i32>(_e147)) + _e142);
let _e160 = global_3.member.member_12.member_4;
let _e161 = bitcast<i32>(_e160);
let _e165 = global_3.member.member_11.member_2;
let _e172 = global_3.member.member_11.member_3;
let _e179 = global_3.member.member_11.member_5;
let _e185 = global_3.member.member_11.member_7;
let _e187 = (_e179 + ((f32(_e142) + 0.5f) * _e185));
let _e191 = global_3.member.member_11.member_6;
let _e197 = global_3.member.member_11.member_8;
let _e199 = (_e191 + ((f32(_e143) + 0.5f) * _e197));
let _e200 = (_e165.member * _e185);
let _e201 = (_e165.member_1 * _e185);
let _e202 = (_e165.member_2 * _e185);
let _e203 = (_e172.member * _e197);
let _e204 = (_e172.member_1 * _e197);
let _e205 = (_e172.member_2 * _e197);
let _e212 = ((_e165.member * _e187) + (_e172.member * _e199));
let _e213 = ((_e165.member_1 * _e187) + (_e172.member_1 * _e199));
let _e214 = ((_e165.member_2 * _e187) + (_e172.member_2 * _e199));
let _e218 = global_3.member.member_11.member_4;
let _e225 = global_3.member.member_11.member_1;
let _e232 = global_3.member.member_10.member;
let _e233 = (_e232 == 0u);
let _e234 = (_e225.member + _e212);
let _e235 = (_e225.member_1 + _e213);
let _e236 = (_e225.member_2 + _e214);
let _e241 = (((_e234 * _e234) + (_e235 * _e235)) + (_e236 * _e236));
let _e245 = (1f / sqrt(select(0f, _e241, (_e241 > 0f))));
let _e249 = select((_e234 * _e245), _e225.member, _e233);
let _e250 = select((_e235 * _e245), _e225.member_1, _e233);
let _e251 = select((_e236 * _e245), _e225.member_2, _e233);
let _e256 = select(_e218.member, (_e218.member + _e212), _e233);
let _e257 = select(_e218.member_1, (_e218.member_1 + _e213), _e233);
let _e258 = select(_e218.member_2, (_e218.member_2 + _e214), _e233);
let _e269 = (((_e200 * _e249) + (_e201 * _e250)) + (_e202 * _e251));
let _e279 = select(((_e200 - (_e249 * _e269)) * _e245), 0f, _e233);
let _e280 = select(((_e201 - (_e250 * _e269)) * _e245), 0f, _e233);
let _e281 = select(((_e202 - (_e251 * _e269)) * _e245), 0f, _e233);
let _e286 = (((_e203 * _e249) + (_e204 * _e250)) + (_e205 * _e251));
let _e296 = select(((_e203 - (_e249 * _e286)) * _e245), 0f, _e233);
let _e297 = select(((_e204 - (_e250 * _e286)) * _e245), 0f, _e233);
let _e298 = select(((_e205 - (_e251 * _e286)) * _e245), 0f, _e233);
let _e306 = (1f / select(_e249, select(1e-12f, -1e-12f, (_e249 < 0f)), (bitcast<f32>((bitcast<u32>(_e249) & 2147483647u)) < 1e-12f)));
let _e314 = (1f / select(_e250, select(1e-12f, -1e-12f, (_e250 < 0f)), (bitcast<f32>((bitcast<u32>(_e250) & 2147483647u)) < 1e-12f)));
let _e322 = (1f / select(_e251, select(1e-12f, -1e-12f, (_e251 < 0f)), (bitcast<f32>((bitcast<u32>(_e251) & 2147483647u)) < 1e-12f)));
let _e325 = global_3.member.member_8;
let _e331 = global_3.member.member_9;
let _e336 = ((_e325.member - _e256) * _e306);
let _e338 = ((_e331.member - _e256) * _e306);
let _e340 = ((_e325.member_1 - _e257) * _e314);
let _e342 = ((_e331.member_1 - _e257) * _e314);
let _e344 = ((_e325.member_2 - _e258) * _e322);
let _e346 = ((_e331.member_2 - _e258) * _e322);
let _e348 = select(_e338, _e336, (_e336 < _e338));
let _e350 = select(_e342, _e340, (_e340 < _e342));
let _e352 = select(_e350, _e348, (_e348 > _e350));
let _e354 = select(_e346, _e344, (_e344 < _e346));
let _e356 = select(_e354, _e352, (_e352 > _e354));
let _e358 = select(_e338, _e336, (_e336 > _e338));
let _e360 = select(_e342, _e340, (_e340 > _e342));
let _e362 = select(_e360, _e358, (_e358 < _e360));
let _e364 = select(_e346, _e344, (_e344 > _e346));
let _e366 = select(_e364, _e362, (_e362 < _e364));
if _e233 {
phi_590_ = -(1e30f);
} else {
phi_590_ = 0f;
}
let _e369 = phi_590_;
let _e371 = select(_e369, _e356, (_e356 > _e369));
let _e374 = ((4i * _e153) + _e156);
let _e376 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e378 = select(_e376, _e374, (_e374 < _e376));
let _e384 = global_4.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e386 = ((5i * _e153) + _e156);
let _e388 = select(_e376, _e386, (_e386 < _e376));
let _e394 = global_4.member[bitcast<u32>(select(0i, _e388, (_e388 > 0i)))];
let _e396 = ((6i * _e153) + _e156);
let _e398 = select(_e376, _e396, (_e396 < _e376));
let _e404 = global_4.member[bitcast<u32>(select(0i, _e398, (_e398 > 0i)))];
let _e406 = ((7i * _e153) + _e156);
let _e408 = select(_e376, _e406, (_e406 < _e376));
let _e414 = global_4.member[bitcast<u32>(select(0i, _e408, (_e408 > 0i)))];
let _e416 = ((8i * _e153) + _e156);
let _e418 = select(_e376, _e416, (_e416 < _e376));
let _e424 = global_4.member[bitcast<u32>(select(0i, _e418, (_e418 > 0i)))];
let _e431 = select(0i, select(select(i32(_e424), i32(-2147483648), (_e424 < -2147483600f)), 2147483647i, (_e424 > 2147483500f)), (_e424 == _e424));
let _e433 = ((9i * _e153) + _e156);
let _e435 = select(_e376, _e433, (_e433 < _e376));
let _e441 = global_4.member[bitcast<u32>(select(0i, _e435, (_e435 > 0i)))];
let _e448 = select(0i, select(select(i32(_e441), i32(-2147483648), (_e441 < -2147483600f)), 2147483647i, (_e441 > 2147483500f)), (_e441 == _e441));
let _e450 = global_6[0u];
let _e452 = global_6[1u];
let _e454 = global_6[2u];
let _e456 = global_6[3u];
let _e458 = global_6[4u];
let _e460 = global_6[5u];
let _e462 = global_6[6u];
let _e464 = global_6[7u];
let _e466 = global_6[8u];
let _e469 = global_6[9u];
let _e471 = global_6[10u];
let _e473 = global_6[11u];
let _e476 = global_6[12u];
let _e478 = global_6[13u];
let _e480 = global_6[14u];
let _e483 = global_6[15u];
let _e485 = global_6[16u];
let _e487 = global_6[17u];
let _e490 = global_6[18u];
let _e492 = global_6[19u];
let _e494 = global_6[20u];
let _e496 = global_6[21u];
let _e503 = select(0i, select(select(i32(_e496), i32(-2147483648), (_e496 < -2147483600f)), 2147483647i, (_e496 > 2147483500f)), (_e496 == _e496));
let _e505 = global_6[22u];
let _e512 = select(0i, select(select(i32(_e505), i32(-2147483648), (_e505 < -2147483600f)), 2147483647i, (_e505 > 2147483500f)), (_e505 == _e505));
let _e514 = global_6[23u];
let _e521 = select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < -2147483600f)), 2147483647i, (_e514 > 2147483500f)), (_e514 == _e514));
let _e523 = global_6[24u];
let _e525 = global_6[25u];
let _e532 = select(0i, select(select(i32(_e525), i32(-2147483648), (_e525 < -2147483600f)), 2147483647i, (_e525 > 2147483500f)), (_e525 == _e525));
let _e534 = global_6[26u];
let _e541 = select(0i, select(select(i32(_e534), i32(-2147483648), (_e534 < -2147483600f)), 2147483647i, (_e534 > 2147483500f)), (_e534 == _e534));
let _e543 = global_6[27u];
let _e545 = global_6[28u];
let _e547 = global_6[30u];
let _e554 = select(0i, select(select(i32(_e547), i32(-2147483648), (_e547 < -2147483600f)), 2147483647i, (_e547 > 2147483500f)), (_e547 == _e547));
let _e556 = global_6[31u];
let _e563 = select(0i, select(select(i32(_e556), i32(-2147483648), (_e556 < -2147483600f)), 2147483647i, (_e556 > 2147483500f)), (_e556 == _e556));
let _e565 = global_6[32u];
let _e572 = select(0i, select(select(i32(_e565), i32(-2147483648), (_e565 < -2147483600f)), 2147483647i, (_e565 > 2147483500f)), (_e565 == _e565));
let _e574 = global_6[33u];
let _e581 = select(0i, select(select(i32(_e574), i32(-2147483648), (_e574 < -2147483600f)), 2147483647i, (_e574 > 2147483500f)), (_e574 == _e574));
let _e583 = global_6[34u];
let _e590 = select(0i, select(select(i32(_e583), i32(-2147483648), (_e583 < -2147483600f)), 2147483647i, (_e583 > 2147483500f)), (_e583 == _e583));
let _e592 = global_6[35u];
let _e599 = select(0i, select(select(i32(_e592), i32(-2147483648), (_e592 < -2147483600f)), 2147483647i, (_e592 > 2147483500f)), (_e592 == _e592));
let _e601 = global_6[36u];
let _e610 = global_6[37u];
let _e612 = global_6[38u];
let _e614 = global_6[39u];
let _e616 = global_6[40u];
let _e618 = global_6[41u];
if (_e366 <= _e371) {
phi_7677_ = array<f32, 42>(_e450, _e452, _e454, _e456, _e458, _e460, _e462, _e464, _e466, _e469, _e471, _e473, _e476, _e478, _e480, _e483, _e485, _e487, _e490, _e492, _e494, f32(_e503), f32(_e512), f32(_e521), _e523, f32(_e532), f32(_e541), _e543, _e545, 3f, f32(_e554), f32(_e563), f32(_e572), f32(_e581), f32(_e590), f32(_e599), f32(select(0i, select(select(i32(_e601), i32(-2147483648), (_e601 < -2147483600f)), 2147483647i, (_e601 > 2147483500f)), (_e601 == _e601))), _e610, _e612, _e614, _e616, _e618);
phi_7678_ = array<f32, 42>();
phi_7679_ = true;
} else {
let _e635 = (_e256 + (_e249 * _e371));
let _e636 = (_e257 + (_e250 * _e371));
let _e637 = (_e258 + (_e251 * _e371));
let _e639 = type_27(vec3<f32>(_e635, _e636, _e637), vec3<f32>(_e249, _e250, _e251), vec3<f32>(_e462, _e464, _e466), vec3<f32>(_e469, _e471, _e473), vec3<f32>(_e476, _e478, _e480), vec3<f32>(_e483, _e485, _e487), vec3<f32>(1f, 1f, 1f), _e503, _e512, _e521, _e523, _e532, _e541, _e543, _e545, 3f, _e554, _e563, _e572, _e581, _e590, _e599, 1i, _e610, _e612, _e614, _e616, _e618);
let _e643 = global_3.member.member_13.member_4;
let _e650 = global_3.member.member_13.member_5;
let _e655 = ((_e643.member - _e256) * _e306);
let _e657 = ((_e650.member - _e256) * _e306);
let _e659 = ((_e643.member_1 - _e257) * _e314);
let _e661 = ((_e650.member_1 - _e257) * _e314);
let _e663 = ((_e643.member_2 - _e258) * _e322);
let _e665 = ((_e650.member_2 - _e258) * _e322);
let _e667 = select(_e657, _e655, (_e655 < _e657));
let _e669 = select(_e661, _e659, (_e659 < _e661));
let _e671 = select(_e669, _e667, (_e667 > _e669));
let _e673 = select(_e665, _e663, (_e663 < _e665));
let _e675 = select(_e673, _e671, (_e671 > _e673));
let _e677 = select(_e657, _e655, (_e655 > _e657));
let _e679 = select(_e661, _e659, (_e659 > _e661));
let _e681 = select(_e679, _e677, (_e677 < _e679));
let _e683 = select(_e665, _e663, (_e663 > _e665));
let _e685 = select(_e683, _e681, (_e681 < _e683));
let _e687 = select(_e369, _e675, (_e675 > _e369));
let _e689 = select(_e371, _e685, (_e685 < _e371));
let _e690 = (_e689 > _e687);
let _e691 = select(_e369, _e687, _e690);
let _e693 = (select(_e369, _e689, _e690) - _e691);
let _e697 = global_3.member.member_13.member_6;
let _e698 = (_e697 == 0u);
if _e698 {
phi_1805_ = _e693;
} else {
let _e700 = (_e693 / f32(_e697));
phi_1092_ = 0u;
phi_1095_ = 0f;
loop {
let _e702 = phi_1092_;
let _e704 = phi_1095_;
local_64 = _e704;
let _e707 = ((_e702 < _e697) && (_e693 > 0f));
if _e707 {
let _e710 = (_e691 + (_e700 * f32(_e702)));
let _e711 = (_e710 + _e700);
let _e713 = (0.5f * (_e710 + _e711));
let _e714 = (_e711 - _e710);
let _e715 = (0.28867513f * _e714);
let _e716 = (_e713 - _e715);
let _e726 = global_3.member.member_13.member_7;
let _e727 = bitcast<i32>(_e726);
let _e731 = global_3.member.member_13.member_8;
let _e732 = bitcast<i32>(_e731);
let _e736 = global_3.member.member_13.member_9;
let _e737 = bitcast<i32>(_e736);
let _e738 = f32(_e727);
let _e740 = (_e650.member - _e643.member);
let _e743 = (((((_e256 + (_e249 * _e716)) - _e643.member) / _e740) * _e738) - 0.5f);
let _e744 = (_e738 - 1f);
let _e746 = select(0f, _e743, (_e743 > 0f));
let _e748 = select(_e744, _e746, (_e746 < _e744));
let _e749 = f32(_e732);
let _e751 = (_e650.member_1 - _e643.member_1);
let _e754 = (((((_e257 + (_e250 * _e716)) - _e643.member_1) / _e751) * _e749) - 0.5f);
let _e755 = (_e749 - 1f);
let _e757 = select(0f, _e754, (_e754 > 0f));
let _e759 = select(_e755, _e757, (_e757 < _e755));
let _e760 = f32(_e737);
let _e762 = (_e650.member_2 - _e643.member_2);
let _e765 = (((((_e258 + (_e251 * _e716)) - _e643.member_2) / _e762) * _e760) - 0.5f);
let _e766 = (_e760 - 1f);
let _e768 = select(0f, _e765, (_e765 > 0f));
let _e770 = select(_e766, _e768, (_e768 < _e766));
let _e772 = select(0f, _e748, (_e748 > 0f));
let _e774 = select(1e6f, _e772, (_e772 < 1e6f));
let _e781 = select(0i, select(select(i32(_e774), i32(-2147483648), (_e774 < -2147483600f)), 2147483647i, (_e774 > 2147483500f)), (_e774 == _e774));
let _e785 = (_e781 - select(0i, 1i, (_e774 < f32(_e781))));
let _e787 = select(0f, _e759, (_e759 > 0f));
let _e789 = select(1e6f, _e787, (_e787 < 1e6f));
let _e796 = select(0i, select(select(i32(_e789), i32(-2147483648), (_e789 < -2147483600f)), 2147483647i, (_e789 > 2147483500f)), (_e789 == _e789));
let _e800 = (_e796 - select(0i, 1i, (_e789 < f32(_e796))));
let _e802 = select(0f, _e770, (_e770 > 0f));
let _e804 = select(1e6f, _e802, (_e802 < 1e6f));
let _e811 = select(0i, select(select(i32(_e804), i32(-2147483648), (_e804 < -2147483600f)), 2147483647i, (_e804 > 2147483500f)), (_e804 == _e804));
let _e815 = (_e811 - select(0i, 1i, (_e804 < f32(_e811))));
let _e819 = (_e759 - f32(_e800));
let _e821 = (_e770 - f32(_e815));
local_10 = (_e748 - f32(_e785));
let _e822 = (_e785 + 1i);
let _e824 = select(_e822, 0i, (_e822 < 0i));
if (_e824 >= _e727) {
phi_1230_ = (_e727 - 1i);
} else {
phi_1230_ = _e824;
}
let _e828 = phi_1230_;
local_11 = (_e828 - _e785);
let _e830 = (_e800 + 1i);
let _e832 = select(_e830, 0i, (_e830 < 0i));
if (_e832 >= _e732) {
phi_1243_ = (_e732 - 1i);
} else {
phi_1243_ = _e832;
}
let _e836 = phi_1243_;
let _e838 = ((_e836 - _e800) * _e727);
let _e839 = (_e815 + 1i);
let _e841 = select(_e839, 0i, (_e839 < 0i));
if (_e841 >= _e737) {
phi_1257_ = (_e737 - 1i);
} else {
phi_1257_ = _e841;
}
let _e845 = phi_1257_;
let _e852 = global_3.member.member_13.member_10;
let _e853 = bitcast<i32>(_e852);
let _e858 = ((_e853 + (((_e815 * _e732) + _e800) * _e727)) + _e785);
let _e860 = (bitcast<i32>(_e129) - 1i);
let _e862 = select(_e860, _e858, (_e858 < _e860));
let _e867 = global_1.member[bitcast<u32>(select(0i, _e862, (_e862 > 0i)))];
let _e868 = local_10;
let _e871 = local_11;
let _e872 = (_e858 + _e871);
let _e874 = select(_e860, _e872, (_e872 < _e860));
let _e879 = global_1.member[bitcast<u32>(select(0i, _e874, (_e874 > 0i)))];
let _e880 = local_10;
let _e883 = (1f - _e819);
let _e885 = (_e858 + _e838);
let _e887 = select(_e860, _e885, (_e885 < _e860));
let _e892 = global_1.member[bitcast<u32>(select(0i, _e887, (_e887 > 0i)))];
let _e893 = local_10;
let _e896 = local_11;
let _e897 = (_e885 + _e896);
let _e899 = select(_e860, _e897, (_e897 < _e860));
let _e904 = global_1.member[bitcast<u32>(select(0i, _e899, (_e899 > 0i)))];
let _e905 = local_10;
let _e910 = (_e858 + (((_e845 - _e815) * _e727) * _e732));
let _e912 = select(_e860, _e910, (_e910 < _e860));
let _e917 = global_1.member[bitcast<u32>(select(0i, _e912, (_e912 > 0i)))];
let _e918 = local_10;
let _e921 = local_11;
let _e922 = (_e910 + _e921);
let _e924 = select(_e860, _e922, (_e922 < _e860));
let _e929 = global_1.member[bitcast<u32>(select(0i, _e924, (_e924 > 0i)))];
let _e930 = local_10;
let _e934 = (_e910 + _e838);
let _e936 = select(_e860, _e934, (_e934 < _e860));
let _e941 = global_1.member[bitcast<u32>(select(0i, _e936, (_e936 > 0i)))];
let _e942 = local_10;
let _e945 = local_11;
let _e946 = (_e934 + _e945);
let _e948 = select(_e860, _e946, (_e946 < _e860));
let _e953 = global_1.member[bitcast<u32>(select(0i, _e948, (_e948 > 0i)))];
let _e954 = local_10;
let _e963 = (_e713 + _e715);
let _e973 = (((((_e256 + (_e249 * _e963)) - _e643.member) / _e740) * _e738) - 0.5f);
let _e975 = select(0f, _e973, (_e973 > 0f));
let _e977 = select(_e744, _e975, (_e975 < _e744));
let _e981 = (((((_e257 + (_e250 * _e963)) - _e643.member_1) / _e751) * _e749) - 0.5f);
let _e983 = select(0f, _e981, (_e981 > 0f));
let _e985 = select(_e755, _e983, (_e983 < _e755));
let _e989 = (((((_e258 + (_e251 * _e963)) - _e643.member_2) / _e762) * _e760) - 0.5f);
let _e991 = select(0f, _e989, (_e989 > 0f));
let _e993 = select(_e766, _e991, (_e991 < _e766));
let _e995 = select(0f, _e977, (_e977 > 0f));
let _e997 = select(1e6f, _e995, (_e995 < 1e6f));
let _e1004 = select(0i, select(select(i32(_e997), i32(-2147483648), (_e997 < -2147483600f)), 2147483647i, (_e997 > 2147483500f)), (_e997 == _e997));
let _e1008 = (_e1004 - select(0i, 1i, (_e997 < f32(_e1004))));
let _e1010 = select(0f, _e985, (_e985 > 0f));
let _e1012 = select(1e6f, _e1010, (_e1010 < 1e6f));
let _e1019 = select(0i, select(select(i32(_e1012), i32(-2147483648), (_e1012 < -2147483600f)), 2147483647i, (_e1012 > 2147483500f)), (_e1012 == _e1012));
let _e1023 = (_e1019 - select(0i, 1i, (_e1012 < f32(_e1019))));
let _e1025 = select(0f, _e993, (_e993 > 0f));
let _e1027 = select(1e6f, _e1025, (_e1025 < 1e6f));
let _e1034 = select(0i, select(select(i32(_e1027), i32(-2147483648), (_e1027 < -2147483600f)), 2147483647i, (_e1027 > 2147483500f)), (_e1027 == _e1027));
let _e1038 = (_e1034 - select(0i, 1i, (_e1027 < f32(_e1034))));
let _e1042 = (_e985 - f32(_e1023));
let _e1044 = (_e993 - f32(_e1038));
local_8 = (_e977 - f32(_e1008));
let _e1045 = (_e1008 + 1i);
let _e1047 = select(_e1045, 0i, (_e1045 < 0i));
if (_e1047 >= _e727) {
phi_1573_ = (_e727 - 1i);
} else {
phi_1573_ = _e1047;
}
let _e1051 = phi_1573_;
local_9 = (_e1051 - _e1008);
let _e1053 = (_e1023 + 1i);
let _e1055 = select(_e1053, 0i, (_e1053 < 0i));
if (_e1055 >= _e732) {
phi_1586_ = (_e732 - 1i);
} else {
phi_1586_ = _e1055;
}
let _e1059 = phi_1586_;
let _e1061 = ((_e1059 - _e1023) * _e727);
let _e1062 = (_e1038 + 1i);
let _e1064 = select(_e1062, 0i, (_e1062 < 0i));
if (_e1064 >= _e737) {
phi_1600_ = (_e737 - 1i);
} else {
phi_1600_ = _e1064;
}
let _e1068 = phi_1600_;
let _e1076 = ((_e853 + (((_e1038 * _e732) + _e1023) * _e727)) + _e1008);
let _e1078 = select(_e860, _e1076, (_e1076 < _e860));
let _e1083 = global_1.member[bitcast<u32>(select(0i, _e1078, (_e1078 > 0i)))];
let _e1084 = local_8;
let _e1087 = local_9;
let _e1088 = (_e1076 + _e1087);
let _e1090 = select(_e860, _e1088, (_e1088 < _e860));
let _e1095 = global_1.member[bitcast<u32>(select(0i, _e1090, (_e1090 > 0i)))];
let _e1096 = local_8;
let _e1099 = (1f - _e1042);
let _e1101 = (_e1076 + _e1061);
let _e1103 = select(_e860, _e1101, (_e1101 < _e860));
let _e1108 = global_1.member[bitcast<u32>(select(0i, _e1103, (_e1103 > 0i)))];
let _e1109 = local_8;
let _e1112 = local_9;
let _e1113 = (_e1101 + _e1112);
let _e1115 = select(_e860, _e1113, (_e1113 < _e860));
let _e1120 = global_1.member[bitcast<u32>(select(0i, _e1115, (_e1115 > 0i)))];
let _e1121 = local_8;
let _e1126 = (_e1076 + (((_e1068 - _e1038) * _e727) * _e732));
let _e1128 = select(_e860, _e1126, (_e1126 < _e860));
let _e1133 = global_1.member[bitcast<u32>(select(0i, _e1128, (_e1128 > 0i)))];
let _e1134 = local_8;
let _e1137 = local_9;
let _e1138 = (_e1126 + _e1137);
let _e1140 = select(_e860, _e1138, (_e1138 < _e860));
let _e1145 = global_1.member[bitcast<u32>(select(0i, _e1140, (_e1140 > 0i)))];
let _e1146 = local_8;
let _e1150 = (_e1126 + _e1061);
let _e1152 = select(_e860, _e1150, (_e1150 < _e860));
let _e1157 = global_1.member[bitcast<u32>(select(0i, _e1152, (_e1152 > 0i)))];
let _e1158 = local_8;
let _e1161 = local_9;
let _e1162 = (_e1150 + _e1161);
let _e1164 = select(_e860, _e1162, (_e1162 < _e860));
let _e1169 = global_1.member[bitcast<u32>(select(0i, _e1164, (_e1164 > 0i)))];
let _e1170 = local_8;
phi_1093_ = (_e702 + 1u);
phi_1096_ = (_e704 + ((0.5f * (((((((_e867 * (1f - _e868)) + (_e879 * _e880)) * _e883) + (((_e892 * (1f - _e893)) + (_e904 * _e905)) * _e819)) * (1f - _e821)) + (((((_e917 * (1f - _e918)) + (_e929 * _e930)) * _e883) + (((_e941 * (1f - _e942)) + (_e953 * _e954)) * _e819)) * _e821)) + ((((((_e1083 * (1f - _e1084)) + (_e1095 * _e1096)) * _e1099) + (((_e1108 * (1f - _e1109)) + (_e1120 * _e1121)) * _e1042)) * (1f - _e1044)) + (((((_e1133 * (1f - _e1134)) + (_e1145 * _e1146)) * _e1099) + (((_e1157 * (1f - _e1158)) + (_e1169 * _e1170)) * _e1042)) * _e1044)))) * _e714));
} else {
phi_1093_ = u32();
phi_1096_ = f32();
}
let _e1185 = phi_1093_;
let _e1187 = phi_1096_;
continue;
continuing {
phi_1092_ = _e1185;
phi_1095_ = _e1187;
break if !(_e707);
}
}
let _e5324 = local_64;
phi_1805_ = _e5324;
}
let _e1190 = phi_1805_;
let _e1194 = global_3.member.member_13.member;
let _e1199 = -((_e1194.member * _e1190));
let _e1201 = select(-87f, _e1199, (_e1199 > -87f));
let _e1203 = select(88f, _e1201, (_e1201 < 88f));
let _e1205 = ((_e1203 * 1.442695f) + 0.5f);
let _e1207 = select(-127f, _e1205, (_e1205 > -127f));
let _e1209 = select(128f, _e1207, (_e1207 < 128f));
let _e1216 = select(0i, select(select(i32(_e1209), i32(-2147483648), (_e1209 < -2147483600f)), 2147483647i, (_e1209 > 2147483500f)), (_e1209 == _e1209));
let _e1220 = (_e1216 - select(0i, 1i, (_e1209 < f32(_e1216))));
let _e1221 = f32(_e1220);
let _e1225 = ((_e1203 - (_e1221 * 0.6933594f)) - (_e1221 * -2.1219444e-4f));
let _e1247 = -((_e1194.member_1 * _e1190));
let _e1249 = select(-87f, _e1247, (_e1247 > -87f));
let _e1251 = select(88f, _e1249, (_e1249 < 88f));
let _e1253 = ((_e1251 * 1.442695f) + 0.5f);
let _e1255 = select(-127f, _e1253, (_e1253 > -127f));
let _e1257 = select(128f, _e1255, (_e1255 < 128f));
let _e1264 = select(0i, select(select(i32(_e1257), i32(-2147483648), (_e1257 < -2147483600f)), 2147483647i, (_e1257 > 2147483500f)), (_e1257 == _e1257));
let _e1268 = (_e1264 - select(0i, 1i, (_e1257 < f32(_e1264))));
let _e1269 = f32(_e1268);
let _e1273 = ((_e1251 - (_e1269 * 0.6933594f)) - (_e1269 * -2.1219444e-4f));
let _e1295 = -((_e1194.member_2 * _e1190));
let _e1297 = select(-87f, _e1295, (_e1295 > -87f));
let _e1299 = select(88f, _e1297, (_e1297 < 88f));
let _e1301 = ((_e1299 * 1.442695f) + 0.5f);
let _e1303 = select(-127f, _e1301, (_e1301 > -127f));
let _e1305 = select(128f, _e1303, (_e1303 < 128f));
let _e1312 = select(0i, select(select(i32(_e1305), i32(-2147483648), (_e1305 < -2147483600f)), 2147483647i, (_e1305 > 2147483500f)), (_e1305 == _e1305));
let _e1316 = (_e1312 - select(0i, 1i, (_e1305 < f32(_e1312))));
let _e1317 = f32(_e1316);
let _e1321 = ((_e1299 - (_e1317 * 0.6933594f)) - (_e1317 * -2.1219444e-4f));
let _e1344 = (1f / 3f);
let _e1346 = (1f * ((1f + (_e1225 * (1f + (_e1225 * (0.5f + (_e1225 * (0.16666667f + (_e1225 * (0.041666668f + (_e1225 * (0.008333334f + (_e1225 * (0.001388889f + (_e1225 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1220 + 127i)) << bitcast<u32>(23i)))));
let _e1347 = (1f * ((1f + (_e1273 * (1f + (_e1273 * (0.5f + (_e1273 * (0.16666667f + (_e1273 * (0.041666668f + (_e1273 * (0.008333334f + (_e1273 * (0.001388889f + (_e1273 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1268 + 127i)) << bitcast<u32>(23i)))));
let _e1348 = (1f * ((1f + (_e1321 * (1f + (_e1321 * (0.5f + (_e1321 * (0.16666667f + (_e1321 * (0.041666668f + (_e1321 * (0.008333334f + (_e1321 * (0.001388889f + (_e1321 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1316 + 127i)) << bitcast<u32>(23i)))));
let _e1357 = (bitcast<i32>(countOneBits(bitcast<u32>((_e563 & ((1i << bitcast<u32>((_e554 & 31i))) - 1i))))) == _e590);
if _e1357 {
phi_2033_ = ((((1f + 1f) + 1f) * _e1344) - (((_e1346 + _e1347) + _e1348) * _e1344));
} else {
phi_2033_ = 0f;
}
let _e1363 = phi_2033_;
let _e1364 = (_e616 + _e1363);
let _e1365 = (_e384 - _e371);
let _e1367 = select(0f, _e1365, (_e1365 > 0f));
let _e1395 = type_27(_e639.member, _e639.member_1, _e639.member_2, _e639.member_3, _e639.member_4, _e639.member_5, _e639.member_6, _e639.member_7, _e639.member_8, _e639.member_9, _e1367, _e639.member_11, _e639.member_12, _e639.member_13, _e639.member_14, _e639.member_15, _e639.member_16, _e639.member_17, _e639.member_18, _e639.member_19, _e639.member_20, _e639.member_21, _e639.member_22, _e639.member_23, _e639.member_24, _e639.member_25, _e639.member_26, _e639.member_27);
let _e1423 = type_27(_e1395.member, _e1395.member_1, _e1395.member_2, _e1395.member_3, _e1395.member_4, _e1395.member_5, _e1395.member_6, _e1395.member_7, _e1395.member_8, _e431, _e1395.member_10, _e1395.member_11, _e1395.member_12, _e1395.member_13, _e1395.member_14, _e1395.member_15, _e1395.member_16, _e1395.member_17, _e1395.member_18, _e1395.member_19, _e1395.member_20, _e1395.member_21, _e1395.member_22, _e1395.member_23, _e1395.member_24, _e1395.member_25, _e1395.member_26, _e1395.member_27);
if (_e161 == 0i) {
phi_7671_ = array<f32, 42>(_e635, _e636, _e637, _e249, _e250, _e251, (select(0f, _e200, _e233) + (_e279 * _e371)), (select(0f, _e201, _e233) + (_e280 * _e371)), (select(0f, _e202, _e233) + (_e281 * _e371)), (select(0f, _e203, _e233) + (_e296 * _e371)), (select(0f, _e204, _e233) + (_e297 * _e371)), (select(0f, _e205, _e233) + (_e298 * _e371)), _e279, _e280, _e281, _e296, _e297, _e298, _e1346, _e1347, _e1348, f32(_e503), f32(_e512), f32(_e431), _e1367, f32(_e532), f32(_e541), _e543, _e545, 2f, f32(_e554), f32(_e563), f32(_e572), f32(_e581), f32(_e590), f32(_e599), 1f, _e610, _e612, _e614, _e1364, (((_e1346 + _e1347) + _e1348) * _e1344));
phi_7672_ = array<f32, 42>();
phi_7673_ = true;
} else {
let _e1453 = ((_e643.member - _e635) * _e306);
let _e1455 = ((_e650.member - _e635) * _e306);
let _e1457 = ((_e643.member_1 - _e636) * _e314);
let _e1459 = ((_e650.member_1 - _e636) * _e314);
let _e1461 = ((_e643.member_2 - _e637) * _e322);
let _e1463 = ((_e650.member_2 - _e637) * _e322);
let _e1465 = select(_e1455, _e1453, (_e1453 < _e1455));
let _e1467 = select(_e1459, _e1457, (_e1457 < _e1459));
let _e1469 = select(_e1467, _e1465, (_e1465 > _e1467));
let _e1471 = select(_e1463, _e1461, (_e1461 < _e1463));
let _e1473 = select(_e1471, _e1469, (_e1469 > _e1471));
let _e1475 = select(_e1455, _e1453, (_e1453 > _e1455));
let _e1477 = select(_e1459, _e1457, (_e1457 > _e1459));
let _e1479 = select(_e1477, _e1475, (_e1475 < _e1477));
let _e1481 = select(_e1463, _e1461, (_e1461 > _e1463));
let _e1483 = select(_e1481, _e1479, (_e1479 < _e1481));
let _e1485 = select(0f, _e1473, (_e1473 > 0f));
let _e1487 = select(_e1367, _e1483, (_e1483 < _e1367));
let _e1488 = (_e1487 > _e1485);
let _e1489 = select(0f, _e1485, _e1488);
let _e1491 = (select(0f, _e1487, _e1488) - _e1489);
if _e698 {
phi_2997_ = _e1491;
} else {
let _e1493 = (_e1491 / f32(_e697));
phi_2272_ = 0u;
phi_2275_ = 0f;
loop {
let _e1495 = phi_2272_;
let _e1497 = phi_2275_;
local_65 = _e1497;
let _e1500 = ((_e1495 < _e697) && (_e1491 > 0f));
if _e1500 {
let _e1503 = (_e1489 + (_e1493 * f32(_e1495)));
let _e1504 = (_e1503 + _e1493);
let _e1506 = (0.5f * (_e1503 + _e1504));
let _e1507 = (_e1504 - _e1503);
let _e1508 = (0.28867513f * _e1507);
let _e1509 = (_e1506 - _e1508);
let _e1519 = global_3.member.member_13.member_7;
let _e1520 = bitcast<i32>(_e1519);
let _e1524 = global_3.member.member_13.member_8;
let _e1525 = bitcast<i32>(_e1524);
let _e1529 = global_3.member.member_13.member_9;
let _e1530 = bitcast<i32>(_e1529);
let _e1531 = f32(_e1520);
let _e1533 = (_e650.member - _e643.member);
let _e1536 = (((((_e635 + (_e249 * _e1509)) - _e643.member) / _e1533) * _e1531) - 0.5f);
let _e1537 = (_e1531 - 1f);
let _e1539 = select(0f, _e1536, (_e1536 > 0f));
let _e1541 = select(_e1537, _e1539, (_e1539 < _e1537));
let _e1542 = f32(_e1525);
let _e1544 = (_e650.member_1 - _e643.member_1);
let _e1547 = (((((_e636 + (_e250 * _e1509)) - _e643.member_1) / _e1544) * _e1542) - 0.5f);
let _e1548 = (_e1542 - 1f);
let _e1550 = select(0f, _e1547, (_e1547 > 0f));
let _e1552 = select(_e1548, _e1550, (_e1550 < _e1548));
let _e1553 = f32(_e1530);
let _e1555 = (_e650.member_2 - _e643.member_2);
let _e1558 = (((((_e637 + (_e251 * _e1509)) - _e643.member_2) / _e1555) * _e1553) - 0.5f);
let _e1559 = (_e1553 - 1f);
let _e1561 = select(0f, _e1558, (_e1558 > 0f));
let _e1563 = select(_e1559, _e1561, (_e1561 < _e1559));
let _e1565 = select(0f, _e1541, (_e1541 > 0f));
let _e1567 = select(1e6f, _e1565, (_e1565 < 1e6f));
let _e1574 = select(0i, select(select(i32(_e1567), i32(-2147483648), (_e1567 < -2147483600f)), 2147483647i, (_e1567 > 2147483500f)), (_e1567 == _e1567));
let _e1578 = (_e1574 - select(0i, 1i, (_e1567 < f32(_e1574))));
let _e1580 = select(0f, _e1552, (_e1552 > 0f));
let _e1582 = select(1e6f, _e1580, (_e1580 < 1e6f));
let _e1589 = select(0i, select(select(i32(_e1582), i32(-2147483648), (_e1582 < -2147483600f)), 2147483647i, (_e1582 > 2147483500f)), (_e1582 == _e1582));
let _e1593 = (_e1589 - select(0i, 1i, (_e1582 < f32(_e1589))));
let _e1595 = select(0f, _e1563, (_e1563 > 0f));
let _e1597 = select(1e6f, _e1595, (_e1595 < 1e6f));
let _e1604 = select(0i, select(select(i32(_e1597), i32(-2147483648), (_e1597 < -2147483600f)), 2147483647i, (_e1597 > 2147483500f)), (_e1597 == _e1597));
let _e1608 = (_e1604 - select(0i, 1i, (_e1597 < f32(_e1604))));
let _e1612 = (_e1552 - f32(_e1593));
let _e1614 = (_e1563 - f32(_e1608));
local_6 = (_e1541 - f32(_e1578));
let _e1615 = (_e1578 + 1i);
let _e1617 = select(_e1615, 0i, (_e1615 < 0i));
if (_e1617 >= _e1520) {
phi_2416_ = (_e1520 - 1i);
} else {
phi_2416_ = _e1617;
}
let _e1621 = phi_2416_;
local_7 = (_e1621 - _e1578);
let _e1623 = (_e1593 + 1i);
let _e1625 = select(_e1623, 0i, (_e1623 < 0i));
if (_e1625 >= _e1525) {
phi_2429_ = (_e1525 - 1i);
} else {
phi_2429_ = _e1625;
}
let _e1629 = phi_2429_;
let _e1631 = ((_e1629 - _e1593) * _e1520);
let _e1632 = (_e1608 + 1i);
let _e1634 = select(_e1632, 0i, (_e1632 < 0i));
if (_e1634 >= _e1530) {
phi_2443_ = (_e1530 - 1i);
} else {
phi_2443_ = _e1634;
}
let _e1638 = phi_2443_;
let _e1645 = global_3.member.member_13.member_10;
let _e1646 = bitcast<i32>(_e1645);
let _e1651 = ((_e1646 + (((_e1608 * _e1525) + _e1593) * _e1520)) + _e1578);
let _e1653 = (bitcast<i32>(_e129) - 1i);
let _e1655 = select(_e1653, _e1651, (_e1651 < _e1653));
let _e1660 = global_1.member[bitcast<u32>(select(0i, _e1655, (_e1655 > 0i)))];
let _e1661 = local_6;
let _e1664 = local_7;
let _e1665 = (_e1651 + _e1664);
let _e1667 = select(_e1653, _e1665, (_e1665 < _e1653));
let _e1672 = global_1.member[bitcast<u32>(select(0i, _e1667, (_e1667 > 0i)))];
let _e1673 = local_6;
let _e1676 = (1f - _e1612);
let _e1678 = (_e1651 + _e1631);
let _e1680 = select(_e1653, _e1678, (_e1678 < _e1653));
let _e1685 = global_1.member[bitcast<u32>(select(0i, _e1680, (_e1680 > 0i)))];
let _e1686 = local_6;
let _e1689 = local_7;
let _e1690 = (_e1678 + _e1689);
let _e1692 = select(_e1653, _e1690, (_e1690 < _e1653));
let _e1697 = global_1.member[bitcast<u32>(select(0i, _e1692, (_e1692 > 0i)))];
let _e1698 = local_6;
let _e1703 = (_e1651 + (((_e1638 - _e1608) * _e1520) * _e1525));
let _e1705 = select(_e1653, _e1703, (_e1703 < _e1653));
let _e1710 = global_1.member[bitcast<u32>(select(0i, _e1705, (_e1705 > 0i)))];
let _e1711 = local_6;
let _e1714 = local_7;
let _e1715 = (_e1703 + _e1714);
let _e1717 = select(_e1653, _e1715, (_e1715 < _e1653));
let _e1722 = global_1.member[bitcast<u32>(select(0i, _e1717, (_e1717 > 0i)))];
let _e1723 = local_6;
let _e1727 = (_e1703 + _e1631);
let _e1729 = select(_e1653, _e1727, (_e1727 < _e1653));
let _e1734 = global_1.member[bitcast<u32>(select(0i, _e1729, (_e1729 > 0i)))];
let _e1735 = local_6;
let _e1738 = local_7;
let _e1739 = (_e1727 + _e1738);
let _e1741 = select(_e1653, _e1739, (_e1739 < _e1653));
let _e1746 = global_1.member[bitcast<u32>(select(0i, _e1741, (_e1741 > 0i)))];
let _e1747 = local_6;
let _e1756 = (_e1506 + _e1508);
let _e1766 = (((((_e635 + (_e249 * _e1756)) - _e643.member) / _e1533) * _e1531) - 0.5f);
let _e1768 = select(0f, _e1766, (_e1766 > 0f));
let _e1770 = select(_e1537, _e1768, (_e1768 < _e1537));
let _e1774 = (((((_e636 + (_e250 * _e1756)) - _e643.member_1) / _e1544) * _e1542) - 0.5f);
let _e1776 = select(0f, _e1774, (_e1774 > 0f));
let _e1778 = select(_e1548, _e1776, (_e1776 < _e1548));
let _e1782 = (((((_e637 + (_e251 * _e1756)) - _e643.member_2) / _e1555) * _e1553) - 0.5f);
let _e1784 = select(0f, _e1782, (_e1782 > 0f));
let _e1786 = select(_e1559, _e1784, (_e1784 < _e1559));
let _e1788 = select(0f, _e1770, (_e1770 > 0f));
let _e1790 = select(1e6f, _e1788, (_e1788 < 1e6f));
let _e1797 = select(0i, select(select(i32(_e1790), i32(-2147483648), (_e1790 < -2147483600f)), 2147483647i, (_e1790 > 2147483500f)), (_e1790 == _e1790));
let _e1801 = (_e1797 - select(0i, 1i, (_e1790 < f32(_e1797))));
let _e1803 = select(0f, _e1778, (_e1778 > 0f));
let _e1805 = select(1e6f, _e1803, (_e1803 < 1e6f));
let _e1812 = select(0i, select(select(i32(_e1805), i32(-2147483648), (_e1805 < -2147483600f)), 2147483647i, (_e1805 > 2147483500f)), (_e1805 == _e1805));
let _e1816 = (_e1812 - select(0i, 1i, (_e1805 < f32(_e1812))));
let _e1818 = select(0f, _e1786, (_e1786 > 0f));
let _e1820 = select(1e6f, _e1818, (_e1818 < 1e6f));
let _e1827 = select(0i, select(select(i32(_e1820), i32(-2147483648), (_e1820 < -2147483600f)), 2147483647i, (_e1820 > 2147483500f)), (_e1820 == _e1820));
let _e1831 = (_e1827 - select(0i, 1i, (_e1820 < f32(_e1827))));
let _e1835 = (_e1778 - f32(_e1816));
let _e1837 = (_e1786 - f32(_e1831));
local_4 = (_e1770 - f32(_e1801));
let _e1838 = (_e1801 + 1i);
let _e1840 = select(_e1838, 0i, (_e1838 < 0i));
if (_e1840 >= _e1520) {
phi_2765_ = (_e1520 - 1i);
} else {
phi_2765_ = _e1840;
}
let _e1844 = phi_2765_;
local_5 = (_e1844 - _e1801);
let _e1846 = (_e1816 + 1i);
let _e1848 = select(_e1846, 0i, (_e1846 < 0i));
if (_e1848 >= _e1525) {
phi_2778_ = (_e1525 - 1i);
} else {
phi_2778_ = _e1848;
}
let _e1852 = phi_2778_;
let _e1854 = ((_e1852 - _e1816) * _e1520);
let _e1855 = (_e1831 + 1i);
let _e1857 = select(_e1855, 0i, (_e1855 < 0i));
if (_e1857 >= _e1530) {
phi_2792_ = (_e1530 - 1i);
} else {
phi_2792_ = _e1857;
}
let _e1861 = phi_2792_;
let _e1869 = ((_e1646 + (((_e1831 * _e1525) + _e1816) * _e1520)) + _e1801);
let _e1871 = select(_e1653, _e1869, (_e1869 < _e1653));
let _e1876 = global_1.member[bitcast<u32>(select(0i, _e1871, (_e1871 > 0i)))];
let _e1877 = local_4;
let _e1880 = local_5;
let _e1881 = (_e1869 + _e1880);
let _e1883 = select(_e1653, _e1881, (_e1881 < _e1653));
let _e1888 = global_1.member[bitcast<u32>(select(0i, _e1883, (_e1883 > 0i)))];
let _e1889 = local_4;
let _e1892 = (1f - _e1835);
let _e1894 = (_e1869 + _e1854);
let _e1896 = select(_e1653, _e1894, (_e1894 < _e1653));
let _e1901 = global_1.member[bitcast<u32>(select(0i, _e1896, (_e1896 > 0i)))];
let _e1902 = local_4;
let _e1905 = local_5;
let _e1906 = (_e1894 + _e1905);
let _e1908 = select(_e1653, _e1906, (_e1906 < _e1653));
let _e1913 = global_1.member[bitcast<u32>(select(0i, _e1908, (_e1908 > 0i)))];
let _e1914 = local_4;
let _e1919 = (_e1869 + (((_e1861 - _e1831) * _e1520) * _e1525));
let _e1921 = select(_e1653, _e1919, (_e1919 < _e1653));
let _e1926 = global_1.member[bitcast<u32>(select(0i, _e1921, (_e1921 > 0i)))];
let _e1927 = local_4;
let _e1930 = local_5;
let _e1931 = (_e1919 + _e1930);
let _e1933 = select(_e1653, _e1931, (_e1931 < _e1653));
let _e1938 = global_1.member[bitcast<u32>(select(0i, _e1933, (_e1933 > 0i)))];
let _e1939 = local_4;
let _e1943 = (_e1919 + _e1854);
let _e1945 = select(_e1653, _e1943, (_e1943 < _e1653));
let _e1950 = global_1.member[bitcast<u32>(select(0i, _e1945, (_e1945 > 0i)))];
let _e1951 = local_4;
let _e1954 = local_5;
let _e1955 = (_e1943 + _e1954);
let _e1957 = select(_e1653, _e1955, (_e1955 < _e1653));
let _e1962 = global_1.member[bitcast<u32>(select(0i, _e1957, (_e1957 > 0i)))];
let _e1963 = local_4;
phi_2273_ = (_e1495 + 1u);
phi_2276_ = (_e1497 + ((0.5f * (((((((_e1660 * (1f - _e1661)) + (_e1672 * _e1673)) * _e1676) + (((_e1685 * (1f - _e1686)) + (_e1697 * _e1698)) * _e1612)) * (1f - _e1614)) + (((((_e1710 * (1f - _e1711)) + (_e1722 * _e1723)) * _e1676) + (((_e1734 * (1f - _e1735)) + (_e1746 * _e1747)) * _e1612)) * _e1614)) + ((((((_e1876 * (1f - _e1877)) + (_e1888 * _e1889)) * _e1892) + (((_e1901 * (1f - _e1902)) + (_e1913 * _e1914)) * _e1835)) * (1f - _e1837)) + (((((_e1926 * (1f - _e1927)) + (_e1938 * _e1939)) * _e1892) + (((_e1950 * (1f - _e1951)) + (_e1962 * _e1963)) * _e1835)) * _e1837)))) * _e1507));
} else {
phi_2273_ = u32();
phi_2276_ = f32();
}
let _e1978 = phi_2273_;
let _e1980 = phi_2276_;
continue;
continuing {
phi_2272_ = _e1978;
phi_2275_ = _e1980;
break if !(_e1500);
}
}
let _e5338 = local_65;
phi_2997_ = _e5338;
}
let _e1983 = phi_2997_;
let _e1985 = -((_e1194.member * _e1983));
let _e1987 = select(-87f, _e1985, (_e1985 > -87f));
let _e1989 = select(88f, _e1987, (_e1987 < 88f));
let _e1991 = ((_e1989 * 1.442695f) + 0.5f);
let _e1993 = select(-127f, _e1991, (_e1991 > -127f));
let _e1995 = select(128f, _e1993, (_e1993 < 128f));
let _e2002 = select(0i, select(select(i32(_e1995), i32(-2147483648), (_e1995 < -2147483600f)), 2147483647i, (_e1995 > 2147483500f)), (_e1995 == _e1995));
let _e2006 = (_e2002 - select(0i, 1i, (_e1995 < f32(_e2002))));
let _e2007 = f32(_e2006);
let _e2011 = ((_e1989 - (_e2007 * 0.6933594f)) - (_e2007 * -2.1219444e-4f));
let _e2033 = -((_e1194.member_1 * _e1983));
let _e2035 = select(-87f, _e2033, (_e2033 > -87f));
let _e2037 = select(88f, _e2035, (_e2035 < 88f));
let _e2039 = ((_e2037 * 1.442695f) + 0.5f);
let _e2041 = select(-127f, _e2039, (_e2039 > -127f));
let _e2043 = select(128f, _e2041, (_e2041 < 128f));
let _e2050 = select(0i, select(select(i32(_e2043), i32(-2147483648), (_e2043 < -2147483600f)), 2147483647i, (_e2043 > 2147483500f)), (_e2043 == _e2043));
let _e2054 = (_e2050 - select(0i, 1i, (_e2043 < f32(_e2050))));
let _e2055 = f32(_e2054);
let _e2059 = ((_e2037 - (_e2055 * 0.6933594f)) - (_e2055 * -2.1219444e-4f));
let _e2081 = -((_e1194.member_2 * _e1983));
let _e2083 = select(-87f, _e2081, (_e2081 > -87f));
let _e2085 = select(88f, _e2083, (_e2083 < 88f));
let _e2087 = ((_e2085 * 1.442695f) + 0.5f);
let _e2089 = select(-127f, _e2087, (_e2087 > -127f));
let _e2091 = select(128f, _e2089, (_e2089 < 128f));
let _e2098 = select(0i, select(select(i32(_e2091), i32(-2147483648), (_e2091 < -2147483600f)), 2147483647i, (_e2091 > 2147483500f)), (_e2091 == _e2091));
let _e2102 = (_e2098 - select(0i, 1i, (_e2091 < f32(_e2098))));
let _e2103 = f32(_e2102);
let _e2107 = ((_e2085 - (_e2103 * 0.6933594f)) - (_e2103 * -2.1219444e-4f));
let _e2131 = (_e1346 * ((1f + (_e2011 * (1f + (_e2011 * (0.5f + (_e2011 * (0.16666667f + (_e2011 * (0.041666668f + (_e2011 * (0.008333334f + (_e2011 * (0.001388889f + (_e2011 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2006 + 127i)) << bitcast<u32>(23i)))));
let _e2132 = (_e1347 * ((1f + (_e2059 * (1f + (_e2059 * (0.5f + (_e2059 * (0.16666667f + (_e2059 * (0.041666668f + (_e2059 * (0.008333334f + (_e2059 * (0.001388889f + (_e2059 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2054 + 127i)) << bitcast<u32>(23i)))));
let _e2133 = (_e1348 * ((1f + (_e2107 * (1f + (_e2107 * (0.5f + (_e2107 * (0.16666667f + (_e2107 * (0.041666668f + (_e2107 * (0.008333334f + (_e2107 * (0.001388889f + (_e2107 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2102 + 127i)) << bitcast<u32>(23i)))));
let _e2134 = vec3<f32>(_e2131, _e2132, _e2133);
let _e2162 = type_27(_e1423.member, _e1423.member_1, _e1423.member_2, _e1423.member_3, _e1423.member_4, _e1423.member_5, _e2134, _e1423.member_7, _e1423.member_8, _e1423.member_9, _e1423.member_10, _e1423.member_11, _e1423.member_12, _e1423.member_13, _e1423.member_14, _e1423.member_15, _e1423.member_16, _e1423.member_17, _e1423.member_18, _e1423.member_19, _e1423.member_20, _e1423.member_21, _e1423.member_22, _e1423.member_23, _e1423.member_24, _e1423.member_25, _e1423.member_26, _e1423.member_27);
if _e1357 {
phi_3230_ = ((((_e1346 + _e1347) + _e1348) * _e1344) - (((_e2131 + _e2132) + _e2133) * _e1344));
} else {
phi_3230_ = 0f;
}
let _e2168 = phi_3230_;
let _e2169 = (_e1364 + _e2168);
let _e2197 = type_27(_e2162.member, _e2162.member_1, _e2162.member_2, _e2162.member_3, _e2162.member_4, _e2162.member_5, _e2162.member_6, _e2162.member_7, _e2162.member_8, _e2162.member_9, _e2162.member_10, _e2162.member_11, _e2162.member_12, _e2162.member_13, _e2162.member_14, _e2162.member_15, _e2162.member_16, _e2162.member_17, _e2162.member_18, _e2162.member_19, _e2162.member_20, _e2162.member_21, _e2162.member_22, _e2162.member_23, _e2162.member_24, _e2162.member_25, _e2169, _e2162.member_27);
if (_e431 >= 0i) {
let _e2199 = (_e448 * 4i);
let _e2201 = (bitcast<i32>(_e129) - 1i);
let _e2203 = select(_e2201, _e2199, (_e2199 < _e2201));
let _e2209 = global_1.member[bitcast<u32>(select(0i, _e2203, (_e2203 > 0i)))];
phi_3262_ = select(_e2209, 1f, (_e448 == 16i));
} else {
phi_3262_ = 0f;
}
let _e2213 = phi_3262_;
let _e2214 = (_e2213 == 0f);
if _e2214 {
let _e2217 = (((_e2131 + _e2132) + _e2133) * _e1344);
let _e2218 = (_e431 == -1i);
phi_7669_ = array<f32, 42>(_e635, _e636, _e637, _e249, _e250, _e251, _e462, _e464, _e466, _e469, _e471, _e473, _e476, _e478, _e480, _e483, _e485, _e487, _e2131, _e2132, _e2133, f32(_e503), f32(_e512), f32(_e431), _e1367, f32(_e532), f32(_e541), _e543, _e545, 3f, f32(_e554), f32(_e563), f32(_e572), f32(_e581), f32(_e590), f32(_e599), 1f, (_e610 + select(0f, _e2217, _e2218)), (_e612 + select(_e2217, 0f, _e2218)), _e614, _e2169, _e618);
phi_7670_ = array<f32, 42>();
} else {
let _e2235 = (_e2213 < 0f);
if _e2235 {
let _e2236 = (_e448 * 4i);
let _e2237 = (_e2236 + 1i);
let _e2239 = (bitcast<i32>(_e129) - 1i);
let _e2241 = select(_e2239, _e2237, (_e2237 < _e2239));
let _e2247 = global_1.member[bitcast<u32>(select(0i, _e2241, (_e2241 > 0i)))];
let _e2248 = (_e2236 + 2i);
let _e2250 = select(_e2239, _e2248, (_e2248 < _e2239));
let _e2256 = global_1.member[bitcast<u32>(select(0i, _e2250, (_e2250 > 0i)))];
let _e2257 = (_e2236 + 3i);
let _e2259 = select(_e2239, _e2257, (_e2257 < _e2239));
let _e2265 = global_1.member[bitcast<u32>(select(0i, _e2259, (_e2259 > 0i)))];
let _e2266 = (_e2131 * _e2247);
let _e2267 = (_e2132 * _e2256);
let _e2268 = (_e2133 * _e2265);
phi_3948_ = vec3<f32>(_e2266, _e2267, _e2268);
phi_3949_ = type_27(_e2197.member, _e2197.member_1, _e2197.member_2, _e2197.member_3, _e2197.member_4, _e2197.member_5, _e2197.member_6, _e2197.member_7, _e2197.member_8, _e2197.member_9, _e2197.member_10, _e2197.member_11, _e2197.member_12, _e2197.member_13, _e2197.member_14, _e2197.member_15, _e2197.member_16, _e2197.member_17, _e2197.member_18, _e2197.member_19, _e2197.member_20, _e2197.member_21, _e2197.member_22, _e2197.member_23, _e2197.member_24, (_e614 + ((((_e2131 + _e2132) + _e2133) * _e1344) - (((_e2266 + _e2267) + _e2268) * _e1344))), _e2197.member_26, _e2197.member_27);
phi_3950_ = vec3<f32>(0f, 0f, 0f);
} else {
let _e2312 = select(1f, -1f, ((((_e249 * _e394) + (_e250 * _e404)) + (_e251 * _e414)) > 0f));
let _e2321 = -((((_e249 * (_e394 * _e2312)) + (_e250 * (_e404 * _e2312))) + (_e251 * (_e414 * _e2312))));
let _e2323 = select(0f, _e2321, (_e2321 > 0f));
let _e2324 = (_e2213 / 1f);
let _e2328 = (((_e2324 * _e2324) - 1f) + (_e2323 * _e2323));
let _e2331 = sqrt(select(0f, _e2328, (_e2328 > 0f)));
let _e2332 = (_e2331 - _e2323);
let _e2333 = (_e2331 + _e2323);
let _e2336 = (_e2332 / select(1e-6f, _e2333, (_e2333 > 1e-6f)));
let _e2340 = ((_e2323 * _e2332) + 1f);
let _e2343 = (((_e2323 * _e2333) - 1f) / select(1e-6f, _e2340, (_e2340 > 1e-6f)));
let _e2352 = select(select((((0.5f * _e2336) * _e2336) * (1f + (_e2343 * _e2343))), 1f, (_e2328 <= 0f)), 0f, (1f == _e2213));
let _e2353 = (1f - _e2352);
let _e2355 = (bitcast<i32>(_e126) - 1i);
let _e2357 = select(_e2355, _e433, (_e433 < _e2355));
let _e2363 = global_5.member[bitcast<u32>(select(0i, _e2357, (_e2357 > 0i)))];
let _e2366 = select(_e2132, _e2131, (_e2131 > _e2132));
let _e2368 = select(_e2133, _e2366, (_e2366 > _e2133));
let _e2373 = global_3.member.member_12.member_1;
let _e2376 = select(0f, _e2353, ((_e2353 >= 0.5f) || ((_e2368 * _e2353) >= _e2373)));
let _e2377 = (_e2131 * _e2376);
let _e2378 = (_e2132 * _e2376);
let _e2379 = (_e2133 * _e2376);
let _e2381 = ((10i * _e153) + _e156);
let _e2383 = select(_e2355, _e2381, (_e2381 < _e2355));
let _e2389 = global_5.member[bitcast<u32>(select(0i, _e2383, (_e2383 > 0i)))];
let _e2390 = (_e448 * 4i);
let _e2391 = (_e2390 + 1i);
let _e2393 = (bitcast<i32>(_e129) - 1i);
let _e2395 = select(_e2393, _e2391, (_e2391 < _e2393));
let _e2401 = global_1.member[bitcast<u32>(select(0i, _e2395, (_e2395 > 0i)))];
let _e2403 = -((_e2401 * _e2389));
let _e2405 = select(-87f, _e2403, (_e2403 > -87f));
let _e2407 = select(88f, _e2405, (_e2405 < 88f));
let _e2409 = ((_e2407 * 1.442695f) + 0.5f);
let _e2411 = select(-127f, _e2409, (_e2409 > -127f));
let _e2413 = select(128f, _e2411, (_e2411 < 128f));
let _e2420 = select(0i, select(select(i32(_e2413), i32(-2147483648), (_e2413 < -2147483600f)), 2147483647i, (_e2413 > 2147483500f)), (_e2413 == _e2413));
let _e2424 = (_e2420 - select(0i, 1i, (_e2413 < f32(_e2420))));
let _e2425 = f32(_e2424);
let _e2429 = ((_e2407 - (_e2425 * 0.6933594f)) - (_e2425 * -2.1219444e-4f));
let _e2450 = (_e2390 + 2i);
let _e2452 = select(_e2393, _e2450, (_e2450 < _e2393));
let _e2458 = global_1.member[bitcast<u32>(select(0i, _e2452, (_e2452 > 0i)))];
let _e2460 = -((_e2458 * _e2389));
let _e2462 = select(-87f, _e2460, (_e2460 > -87f));
let _e2464 = select(88f, _e2462, (_e2462 < 88f));
let _e2466 = ((_e2464 * 1.442695f) + 0.5f);
let _e2468 = select(-127f, _e2466, (_e2466 > -127f));
let _e2470 = select(128f, _e2468, (_e2468 < 128f));
let _e2477 = select(0i, select(select(i32(_e2470), i32(-2147483648), (_e2470 < -2147483600f)), 2147483647i, (_e2470 > 2147483500f)), (_e2470 == _e2470));
let _e2481 = (_e2477 - select(0i, 1i, (_e2470 < f32(_e2477))));
let _e2482 = f32(_e2481);
let _e2486 = ((_e2464 - (_e2482 * 0.6933594f)) - (_e2482 * -2.1219444e-4f));
let _e2507 = (_e2390 + 3i);
let _e2509 = select(_e2393, _e2507, (_e2507 < _e2393));
let _e2515 = global_1.member[bitcast<u32>(select(0i, _e2509, (_e2509 > 0i)))];
let _e2517 = -((_e2515 * _e2389));
let _e2519 = select(-87f, _e2517, (_e2517 > -87f));
let _e2521 = select(88f, _e2519, (_e2519 < 88f));
let _e2523 = ((_e2521 * 1.442695f) + 0.5f);
let _e2525 = select(-127f, _e2523, (_e2523 > -127f));
let _e2527 = select(128f, _e2525, (_e2525 < 128f));
let _e2534 = select(0i, select(select(i32(_e2527), i32(-2147483648), (_e2527 < -2147483600f)), 2147483647i, (_e2527 > 2147483500f)), (_e2527 == _e2527));
let _e2538 = (_e2534 - select(0i, 1i, (_e2527 < f32(_e2534))));
let _e2539 = f32(_e2538);
let _e2543 = ((_e2521 - (_e2539 * 0.6933594f)) - (_e2539 * -2.1219444e-4f));
let _e2564 = (_e2377 * ((1f + (_e2429 * (1f + (_e2429 * (0.5f + (_e2429 * (0.16666667f + (_e2429 * (0.041666668f + (_e2429 * (0.008333334f + (_e2429 * (0.001388889f + (_e2429 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2424 + 127i)) << bitcast<u32>(23i)))));
let _e2565 = (_e2378 * ((1f + (_e2486 * (1f + (_e2486 * (0.5f + (_e2486 * (0.16666667f + (_e2486 * (0.041666668f + (_e2486 * (0.008333334f + (_e2486 * (0.001388889f + (_e2486 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2481 + 127i)) << bitcast<u32>(23i)))));
let _e2566 = (_e2379 * ((1f + (_e2543 * (1f + (_e2543 * (0.5f + (_e2543 * (0.16666667f + (_e2543 * (0.041666668f + (_e2543 * (0.008333334f + (_e2543 * (0.001388889f + (_e2543 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2538 + 127i)) << bitcast<u32>(23i)))));
let _e2567 = (1f - _e2363);
let _e2568 = (_e2564 * _e2567);
let _e2569 = (_e2565 * _e2567);
let _e2570 = (_e2566 * _e2567);
let _e2576 = select(0f, _e2352, ((_e2352 >= 0.5f) || ((_e2368 * _e2352) >= _e2373)));
let _e2583 = (((_e2377 + _e2378) + _e2379) * _e1344);
let _e2586 = (((_e2564 + _e2565) + _e2566) * _e1344);
let _e2616 = type_27(_e2197.member, _e2197.member_1, _e2197.member_2, _e2197.member_3, _e2197.member_4, _e2197.member_5, _e2197.member_6, _e2197.member_7, _e2197.member_8, _e2197.member_9, _e2197.member_10, _e2197.member_11, _e2197.member_12, _e2197.member_13, _e2197.member_14, _e2197.member_15, _e2197.member_16, _e2197.member_17, _e2197.member_18, _e2197.member_19, _e2197.member_20, _e2197.member_21, _e2197.member_22, _e2197.member_23, _e2197.member_24, (_e614 + (_e2583 - _e2586)), _e2197.member_26, _e2197.member_27);
phi_3948_ = vec3<f32>(_e2568, _e2569, _e2570);
phi_3949_ = type_27(_e2616.member, _e2616.member_1, _e2616.member_2, _e2616.member_3, _e2616.member_4, _e2616.member_5, _e2616.member_6, _e2616.member_7, _e2616.member_8, _e2616.member_9, _e2616.member_10, _e2616.member_11, _e2616.member_12, _e2616.member_13, _e2616.member_14, _e2616.member_15, _e2616.member_16, _e2616.member_17, _e2616.member_18, _e2616.member_19, _e2616.member_20, _e2616.member_21, _e2616.member_22, _e2616.member_23, _e2616.member_24, _e2616.member_25, _e2616.member_26, (((_e618 + (((((_e2131 * _e2353) + (_e2132 * _e2353)) + (_e2133 * _e2353)) * _e1344) - _e2583)) + (_e2586 - (((_e2568 + _e2569) + _e2570) * _e1344))) + (((((_e2131 * _e2352) + (_e2132 * _e2352)) + (_e2133 * _e2352)) * _e1344) - ((((_e2131 * _e2576) + (_e2132 * _e2576)) + (_e2133 * _e2576)) * _e1344))));
phi_3950_ = (_e2134 * _e2576);
}
let _e2670 = phi_3948_;
let _e2672 = phi_3949_;
let _e2674 = phi_3950_;
phi_3953_ = _e2672;
phi_3956_ = 1i;
loop {
let _e2676 = phi_3953_;
let _e2678 = phi_3956_;
local_22 = _e2676;
local_23 = _e2676;
local_24 = _e2676;
local_25 = _e2676;
local_26 = _e2676;
local_27 = _e2676;
local_28 = _e2676;
local_29 = _e2676;
local_30 = _e2676;
local_31 = _e2676;
local_32 = _e2676;
local_33 = _e2676;
local_34 = _e2676;
local_35 = _e2676;
local_36 = _e2676;
local_37 = _e2676;
local_38 = _e2676;
local_39 = _e2676;
local_40 = _e2676;
local_41 = _e2676;
local_42 = _e2676;
local_43 = _e2676;
local_44 = _e2676;
local_45 = _e2676;
local_46 = _e2676;
local_47 = _e2676;
local_48 = _e2676;
local_49 = _e2676;
local_50 = _e2676;
local_51 = _e2676;
local_52 = _e2676;
local_53 = _e2676;
local_54 = _e2676;
local_55 = _e2676;
local_56 = _e2676;
local_57 = _e2676;
local_58 = _e2676;
local_59 = _e2676;
local_60 = _e2676;
local_61 = _e2676;
local_62 = _e2676;
local_63 = _e2676;
let _e2679 = (_e2678 <= 2i);
if _e2679 {
let _e2682 = select(_e2674, _e2670, vec3((_e2678 == 1i)));
let _e2688 = (((_e2682.x + _e2682.y) + _e2682.z) * _e1344);
let _e2689 = (_e2688 > 0f);
if (_e2689 && (_e2678 > _e161)) {
phi_7612_ = type_27(_e2676.member, _e2676.member_1, _e2676.member_2, _e2676.member_3, _e2676.member_4, _e2676.member_5, _e2676.member_6, _e2676.member_7, _e2676.member_8, _e2676.member_9, _e2676.member_10, _e2676.member_11, _e2676.member_12, _e2676.member_13, _e2676.member_14, _e2676.member_15, _e2676.member_16, _e2676.member_17, _e2676.member_18, _e2676.member_19, _e2676.member_20, _e2676.member_21, _e2676.member_22, _e2676.member_23, _e2676.member_24, _e2676.member_25, _e2676.member_26, (_e2676.member_27 + _e2688));
} else {
if _e2689 {
let _e2723 = (_e2235 || (_e2678 == 2i));
let _e2727 = global_3.member.member_11.member;
let _e2728 = bitcast<i32>(_e2727);
let _e2729 = (_e2728 * _e2728);
let _e2731 = ((_e143 * _e2728) + _e142);
let _e2732 = (4i * _e2729);
let _e2733 = (_e2732 + _e2731);
let _e2735 = select(_e376, _e2733, (_e2733 < _e376));
let _e2741 = global_4.member[bitcast<u32>(select(0i, _e2735, (_e2735 > 0i)))];
let _e2742 = (5i * _e2729);
let _e2743 = (_e2742 + _e2731);
let _e2745 = select(_e376, _e2743, (_e2743 < _e376));
let _e2751 = global_4.member[bitcast<u32>(select(0i, _e2745, (_e2745 > 0i)))];
let _e2752 = (6i * _e2729);
let _e2753 = (_e2752 + _e2731);
let _e2755 = select(_e376, _e2753, (_e2753 < _e376));
let _e2761 = global_4.member[bitcast<u32>(select(0i, _e2755, (_e2755 > 0i)))];
let _e2762 = (7i * _e2729);
let _e2763 = (_e2762 + _e2731);
let _e2765 = select(_e376, _e2763, (_e2763 < _e376));
let _e2771 = global_4.member[bitcast<u32>(select(0i, _e2765, (_e2765 > 0i)))];
let _e2772 = vec3<f32>(_e2751, _e2761, _e2771);
let _e2773 = (8i * _e2729);
let _e2774 = (_e2773 + _e2731);
let _e2776 = select(_e376, _e2774, (_e2774 < _e376));
let _e2782 = global_4.member[bitcast<u32>(select(0i, _e2776, (_e2776 > 0i)))];
let _e2790 = (9i * _e2729);
let _e2791 = (_e2790 + _e2731);
let _e2793 = select(_e376, _e2791, (_e2791 < _e376));
let _e2799 = global_4.member[bitcast<u32>(select(0i, _e2793, (_e2793 > 0i)))];
let _e2806 = select(0i, select(select(i32(_e2799), i32(-2147483648), (_e2799 < -2147483600f)), 2147483647i, (_e2799 > 2147483500f)), (_e2799 == _e2799));
if _e233 {
phi_4357_ = -(1e30f);
} else {
phi_4357_ = 0f;
}
let _e2809 = phi_4357_;
let _e2819 = vec3<f32>((_e256 + (_e249 * _e2741)), (_e257 + (_e250 * _e2741)), (_e258 + (_e251 * _e2741)));
let _e2826 = ((((_e142 >= 0i) && (_e143 >= 0i)) && (_e142 < _e2728)) && (_e143 < _e2728));
let _e2829 = (select(0i, select(select(i32(_e2782), i32(-2147483648), (_e2782 < -2147483600f)), 2147483647i, (_e2782 > 2147483500f)), (_e2782 == _e2782)) >= 0i);
if ((_e2826 && !((_e366 <= select(_e2809, _e356, (_e356 > _e2809))))) && _e2829) {
let _e2831 = (_e2806 * 4i);
let _e2833 = (bitcast<i32>(_e129) - 1i);
let _e2835 = select(_e2833, _e2831, (_e2831 < _e2833));
let _e2841 = global_1.member[bitcast<u32>(select(0i, _e2835, (_e2835 > 0i)))];
phi_4409_ = select(_e2841, 1f, (_e2806 == 16i));
} else {
phi_4409_ = 0f;
}
let _e2845 = phi_4409_;
let _e2851 = (bitcast<i32>(_e126) - 1i);
let _e2853 = select(_e2851, _e2791, (_e2791 < _e2851));
let _e2859 = global_5.member[bitcast<u32>(select(0i, _e2853, (_e2853 > 0i)))];
let _e2861 = (_e2723 || (_e2859 < 1f));
let _e2863 = select(-1i, _e2806, (((_e2845 > 0f) || (_e2723 && (_e2845 < 0f))) && _e2861));
if _e2723 {
let _e2870 = select(1f, -1f, ((((_e249 * _e2751) + (_e250 * _e2761)) + (_e251 * _e2771)) > 0f));
let _e2871 = (_e2751 * _e2870);
let _e2872 = (_e2761 * _e2870);
let _e2873 = (_e2771 * _e2870);
let _e2879 = -((((_e249 * _e2871) + (_e250 * _e2872)) + (_e251 * _e2873)));
let _e2882 = (2f * select(0f, _e2879, (_e2879 > 0f)));
phi_4705_ = type_28(_e2819, vec3<f32>((_e249 + (_e2871 * _e2882)), (_e250 + (_e2872 * _e2882)), (_e251 + (_e2873 * _e2882))), _e2772, _e2819, _e2772, _e2863);
} else {
let _e2892 = select(_e2851, _e2731, (_e2731 < _e2851));
let _e2898 = global_5.member[bitcast<u32>(select(0i, _e2892, (_e2892 > 0i)))];
let _e2899 = (_e2729 + _e2731);
let _e2901 = select(_e2851, _e2899, (_e2899 < _e2851));
let _e2907 = global_5.member[bitcast<u32>(select(0i, _e2901, (_e2901 > 0i)))];
let _e2909 = ((2i * _e2729) + _e2731);
let _e2911 = select(_e2851, _e2909, (_e2909 < _e2851));
let _e2917 = global_5.member[bitcast<u32>(select(0i, _e2911, (_e2911 > 0i)))];
let _e2920 = ((3i * _e2729) + _e2731);
let _e2922 = select(_e2851, _e2920, (_e2920 < _e2851));
let _e2928 = global_5.member[bitcast<u32>(select(0i, _e2922, (_e2922 > 0i)))];
let _e2930 = select(_e2851, _e2733, (_e2733 < _e2851));
let _e2936 = global_5.member[bitcast<u32>(select(0i, _e2930, (_e2930 > 0i)))];
let _e2938 = select(_e2851, _e2743, (_e2743 < _e2851));
let _e2944 = global_5.member[bitcast<u32>(select(0i, _e2938, (_e2938 > 0i)))];
let _e2947 = select(_e2851, _e2753, (_e2753 < _e2851));
let _e2953 = global_5.member[bitcast<u32>(select(0i, _e2947, (_e2947 > 0i)))];
let _e2955 = select(_e2851, _e2763, (_e2763 < _e2851));
let _e2961 = global_5.member[bitcast<u32>(select(0i, _e2955, (_e2955 > 0i)))];
let _e2963 = select(_e2851, _e2774, (_e2774 < _e2851));
let _e2969 = global_5.member[bitcast<u32>(select(0i, _e2963, (_e2963 > 0i)))];
phi_4705_ = type_28(vec3<f32>(_e2898, _e2907, _e2917), vec3<f32>(_e2928, _e2936, _e2944), vec3<f32>(_e2953, _e2961, _e2969), _e2819, _e2772, _e2863);
}
let _e2973 = phi_4705_;
let _e2980 = global_3.member.member_14.member.member;
let _e2994 = ((((_e2980.member.member * _e2973.member.x) + (_e2980.member.member_1 * _e2973.member.y)) + (_e2980.member.member_2 * _e2973.member.z)) + _e2980.member_1);
let _e3003 = -((((_e2980.member.member * _e2973.member_1.x) + (_e2980.member.member_1 * _e2973.member_1.y)) + (_e2980.member.member_2 * _e2973.member_1.z)));
let _e3005 = (_e3003 > 1e-9f);
let _e3009 = ((_e2994 / select(1e-9f, _e3003, _e3005)) - 0.015625f);
let _e3012 = select(1e30f, select(0f, _e3009, (_e3009 > 0f)), ((_e2994 > 0f) && _e3005));
let _e3017 = global_3.member.member_14.member_1.member;
let _e3028 = ((((_e3017.member.member * _e2973.member.x) + (_e3017.member.member_1 * _e2973.member.y)) + (_e3017.member.member_2 * _e2973.member.z)) + _e3017.member_1);
let _e3034 = -((((_e3017.member.member * _e2973.member_1.x) + (_e3017.member.member_1 * _e2973.member_1.y)) + (_e3017.member.member_2 * _e2973.member_1.z)));
let _e3036 = (_e3034 > 1e-9f);
let _e3040 = ((_e3028 / select(1e-9f, _e3034, _e3036)) - 0.015625f);
let _e3043 = select(1e30f, select(0f, _e3040, (_e3040 > 0f)), ((_e3028 > 0f) && _e3036));
let _e3047 = (_e3043 < _e3012);
let _e3049 = select(select(-2i, -3i, _e3047), -1i, ((_e3012 >= 1e30f) && (_e3043 >= 1e30f)));
let _e3050 = select(_e3012, _e3043, _e3047);
if (_e2678 == _e161) {
let _e3079 = type_27(_e2676.member, _e2676.member_1, _e2676.member_2, _e2676.member_3, _e2676.member_4, _e2676.member_5, _e2676.member_6, _e2676.member_7, _e2676.member_8, _e2676.member_9, _e2676.member_10, _e2676.member_11, _e2676.member_12, _e2676.member_13, _e2676.member_14, 2f, _e2676.member_16, _e2676.member_17, _e2676.member_18, _e2676.member_19, _e2676.member_20, _e2676.member_21, _e2676.member_22, _e2676.member_23, _e2676.member_24, _e2676.member_25, _e2676.member_26, _e2676.member_27);
let _e3108 = type_27(_e3079.member, _e3079.member_1, _e3079.member_2, _e3079.member_3, _e3079.member_4, _e3079.member_5, _e3079.member_6, _e3079.member_7, _e3079.member_8, _e3079.member_9, _e3079.member_10, _e3079.member_11, _e3079.member_12, _e3079.member_13, _e3079.member_14, _e3079.member_15, _e3079.member_16, _e3079.member_17, _e3079.member_18, _e3079.member_19, _e3079.member_20, _e3079.member_21, (_e2678 + 1i), _e3079.member_23, _e3079.member_24, _e3079.member_25, _e3079.member_26, _e3079.member_27);
let _e3137 = type_27(_e3108.member, _e3108.member_1, _e3108.member_2, _e3108.member_3, _e3108.member_4, _e3108.member_5, _e3108.member_6, _e3108.member_7, _e3108.member_8, _e3108.member_9, _e3108.member_10, _e3108.member_11, _e3108.member_12, _e3108.member_13, _e3108.member_14, _e3108.member_15, select(2i, 1i, _e2723), _e3108.member_17, _e3108.member_18, _e3108.member_19, _e3108.member_20, _e3108.member_21, _e3108.member_22, _e3108.member_23, _e3108.member_24, _e3108.member_25, _e3108.member_26, _e3108.member_27);
let _e3165 = type_27(_e2973.member, _e3137.member_1, _e3137.member_2, _e3137.member_3, _e3137.member_4, _e3137.member_5, _e3137.member_6, _e3137.member_7, _e3137.member_8, _e3137.member_9, _e3137.member_10, _e3137.member_11, _e3137.member_12, _e3137.member_13, _e3137.member_14, _e3137.member_15, _e3137.member_16, _e3137.member_17, _e3137.member_18, _e3137.member_19, _e3137.member_20, _e3137.member_21, _e3137.member_22, _e3137.member_23, _e3137.member_24, _e3137.member_25, _e3137.member_26, _e3137.member_27);
let _e3193 = type_27(_e3165.member, _e2973.member_1, _e3165.member_2, _e3165.member_3, _e3165.member_4, _e3165.member_5, _e3165.member_6, _e3165.member_7, _e3165.member_8, _e3165.member_9, _e3165.member_10, _e3165.member_11, _e3165.member_12, _e3165.member_13, _e3165.member_14, _e3165.member_15, _e3165.member_16, _e3165.member_17, _e3165.member_18, _e3165.member_19, _e3165.member_20, _e3165.member_21, _e3165.member_22, _e3165.member_23, _e3165.member_24, _e3165.member_25, _e3165.member_26, _e3165.member_27);
if _e233 {
phi_5203_ = -(1e30f);
} else {
phi_5203_ = 0f;
}
let _e3196 = phi_5203_;
if ((_e2826 && !((_e366 <= select(_e3196, _e356, (_e356 > _e3196))))) && _e2829) {
let _e3203 = (_e2806 * 4i);
let _e3205 = (bitcast<i32>(_e129) - 1i);
let _e3207 = select(_e3205, _e3203, (_e3203 < _e3205));
let _e3213 = global_1.member[bitcast<u32>(select(0i, _e3207, (_e3207 > 0i)))];
phi_5255_ = select(_e3213, 1f, (_e2806 == 16i));
} else {
phi_5255_ = 0f;
}
let _e3217 = phi_5255_;
let _e3223 = select(-1i, _e2806, (((_e3217 > 0f) || (_e2723 && (_e3217 < 0f))) && _e2861));
if _e2723 {
let _e3230 = select(1f, -1f, ((((_e249 * _e2751) + (_e250 * _e2761)) + (_e251 * _e2771)) > 0f));
let _e3231 = (_e2751 * _e3230);
let _e3232 = (_e2761 * _e3230);
let _e3233 = (_e2771 * _e3230);
let _e3239 = -((((_e249 * _e3231) + (_e250 * _e3232)) + (_e251 * _e3233)));
let _e3242 = (2f * select(0f, _e3239, (_e3239 > 0f)));
phi_5551_ = type_28(_e2819, vec3<f32>((_e249 + (_e3231 * _e3242)), (_e250 + (_e3232 * _e3242)), (_e251 + (_e3233 * _e3242))), _e2772, _e2819, _e2772, _e3223);
} else {
let _e3252 = select(_e2851, _e2731, (_e2731 < _e2851));
let _e3258 = global_5.member[bitcast<u32>(select(0i, _e3252, (_e3252 > 0i)))];
let _e3259 = (_e2729 + _e2731);
let _e3261 = select(_e2851, _e3259, (_e3259 < _e2851));
let _e3267 = global_5.member[bitcast<u32>(select(0i, _e3261, (_e3261 > 0i)))];
let _e3269 = ((2i * _e2729) + _e2731);
let _e3271 = select(_e2851, _e3269, (_e3269 < _e2851));
let _e3277 = global_5.member[bitcast<u32>(select(0i, _e3271, (_e3271 > 0i)))];
let _e3280 = ((3i * _e2729) + _e2731);
let _e3282 = select(_e2851, _e3280, (_e3280 < _e2851));
let _e3288 = global_5.member[bitcast<u32>(select(0i, _e3282, (_e3282 > 0i)))];
let _e3290 = select(_e2851, _e2733, (_e2733 < _e2851));
let _e3296 = global_5.member[bitcast<u32>(select(0i, _e3290, (_e3290 > 0i)))];
let _e3298 = select(_e2851, _e2743, (_e2743 < _e2851));
let _e3304 = global_5.member[bitcast<u32>(select(0i, _e3298, (_e3298 > 0i)))];
let _e3307 = select(_e2851, _e2753, (_e2753 < _e2851));
let _e3313 = global_5.member[bitcast<u32>(select(0i, _e3307, (_e3307 > 0i)))];
let _e3315 = select(_e2851, _e2763, (_e2763 < _e2851));
let _e3321 = global_5.member[bitcast<u32>(select(0i, _e3315, (_e3315 > 0i)))];
let _e3323 = select(_e2851, _e2774, (_e2774 < _e2851));
let _e3329 = global_5.member[bitcast<u32>(select(0i, _e3323, (_e3323 > 0i)))];
phi_5551_ = type_28(vec3<f32>(_e3258, _e3267, _e3277), vec3<f32>(_e3288, _e3296, _e3304), vec3<f32>(_e3313, _e3321, _e3329), _e2819, _e2772, _e3223);
}
let _e3333 = phi_5551_;
phi_5555_ = 0i;
phi_5558_ = type_29(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
loop {
let _e3335 = phi_5555_;
let _e3337 = phi_5558_;
local_18 = _e3337;
local_19 = _e3337;
local_20 = _e3337;
local_21 = _e3337;
let _e3338 = (_e3335 < 2i);
if _e3338 {
phi_5568_ = vec3<f32>(0f, 0f, 0f);
phi_5571_ = vec3<f32>(0f, 0f, 0f);
phi_5573_ = -1i;
phi_5575_ = 0f;
loop {
let _e3341 = phi_5568_;
let _e3343 = phi_5571_;
let _e3345 = phi_5573_;
let _e3347 = phi_5575_;
local_12 = _e3347;
local_13 = _e3347;
local_14 = _e3343;
local_15 = _e3341;
local_16 = _e3343;
local_17 = _e3341;
let _e3348 = (_e3345 <= 1i);
if _e3348 {
let _e3350 = (_e142 + (_e3345 * (1i - _e3335)));
let _e3352 = (_e143 + (_e3345 * _e3335));
let _e3354 = ((_e3352 * _e2728) + _e3350);
let _e3355 = (_e2732 + _e3354);
let _e3357 = select(_e376, _e3355, (_e3355 < _e376));
let _e3363 = global_4.member[bitcast<u32>(select(0i, _e3357, (_e3357 > 0i)))];
let _e3364 = (_e2742 + _e3354);
let _e3366 = select(_e376, _e3364, (_e3364 < _e376));
let _e3372 = global_4.member[bitcast<u32>(select(0i, _e3366, (_e3366 > 0i)))];
let _e3373 = (_e2752 + _e3354);
let _e3375 = select(_e376, _e3373, (_e3373 < _e376));
let _e3381 = global_4.member[bitcast<u32>(select(0i, _e3375, (_e3375 > 0i)))];
let _e3382 = (_e2762 + _e3354);
let _e3384 = select(_e376, _e3382, (_e3382 < _e376));
let _e3390 = global_4.member[bitcast<u32>(select(0i, _e3384, (_e3384 > 0i)))];
let _e3391 = vec3<f32>(_e3372, _e3381, _e3390);
let _e3392 = (_e2773 + _e3354);
let _e3394 = select(_e376, _e3392, (_e3392 < _e376));
let _e3400 = global_4.member[bitcast<u32>(select(0i, _e3394, (_e3394 > 0i)))];
let _e3408 = (_e2790 + _e3354);
let _e3410 = select(_e376, _e3408, (_e3408 < _e376));
let _e3416 = global_4.member[bitcast<u32>(select(0i, _e3410, (_e3410 > 0i)))];
let _e3423 = select(0i, select(select(i32(_e3416), i32(-2147483648), (_e3416 < -2147483600f)), 2147483647i, (_e3416 > 2147483500f)), (_e3416 == _e3416));
let _e3427 = (_e179 + ((f32(_e3350) + 0.5f) * _e185));
let _e3431 = (_e191 + ((f32(_e3352) + 0.5f) * _e197));
let _e3438 = ((_e165.member * _e3427) + (_e172.member * _e3431));
let _e3439 = ((_e165.member_1 * _e3427) + (_e172.member_1 * _e3431));
let _e3440 = ((_e165.member_2 * _e3427) + (_e172.member_2 * _e3431));
let _e3441 = (_e225.member + _e3438);
let _e3442 = (_e225.member_1 + _e3439);
let _e3443 = (_e225.member_2 + _e3440);
let _e3448 = (((_e3441 * _e3441) + (_e3442 * _e3442)) + (_e3443 * _e3443));
let _e3452 = (1f / sqrt(select(0f, _e3448, (_e3448 > 0f))));
let _e3456 = select((_e3441 * _e3452), _e225.member, _e233);
let _e3457 = select((_e3442 * _e3452), _e225.member_1, _e233);
let _e3458 = select((_e3443 * _e3452), _e225.member_2, _e233);
let _e3462 = select(_e218.member, (_e218.member + _e3438), _e233);
let _e3463 = select(_e218.member_1, (_e218.member_1 + _e3439), _e233);
let _e3464 = select(_e218.member_2, (_e218.member_2 + _e3440), _e233);
let _e3472 = (1f / select(_e3456, select(1e-12f, -1e-12f, (_e3456 < 0f)), (bitcast<f32>((bitcast<u32>(_e3456) & 2147483647u)) < 1e-12f)));
let _e3480 = (1f / select(_e3457, select(1e-12f, -1e-12f, (_e3457 < 0f)), (bitcast<f32>((bitcast<u32>(_e3457) & 2147483647u)) < 1e-12f)));
let _e3488 = (1f / select(_e3458, select(1e-12f, -1e-12f, (_e3458 < 0f)), (bitcast<f32>((bitcast<u32>(_e3458) & 2147483647u)) < 1e-12f)));
let _e3490 = ((_e325.member - _e3462) * _e3472);
let _e3492 = ((_e331.member - _e3462) * _e3472);
let _e3494 = ((_e325.member_1 - _e3463) * _e3480);
let _e3496 = ((_e331.member_1 - _e3463) * _e3480);
let _e3498 = ((_e325.member_2 - _e3464) * _e3488);
let _e3500 = ((_e331.member_2 - _e3464) * _e3488);
let _e3502 = select(_e3492, _e3490, (_e3490 < _e3492));
let _e3504 = select(_e3496, _e3494, (_e3494 < _e3496));
let _e3506 = select(_e3504, _e3502, (_e3502 > _e3504));
let _e3508 = select(_e3500, _e3498, (_e3498 < _e3500));
let _e3510 = select(_e3508, _e3506, (_e3506 > _e3508));
let _e3512 = select(_e3492, _e3490, (_e3490 > _e3492));
let _e3514 = select(_e3496, _e3494, (_e3494 > _e3496));
let _e3516 = select(_e3514, _e3512, (_e3512 < _e3514));
let _e3518 = select(_e3500, _e3498, (_e3498 > _e3500));
if _e233 {
phi_5953_ = -(1e30f);
} else {
phi_5953_ = 0f;
}
let _e3523 = phi_5953_;
let _e3533 = vec3<f32>((_e3462 + (_e3456 * _e3363)), (_e3463 + (_e3457 * _e3363)), (_e3464 + (_e3458 * _e3363)));
if ((((((_e3350 >= 0i) && (_e3352 >= 0i)) && (_e3350 < _e2728)) && (_e3352 < _e2728)) && !((select(_e3518, _e3516, (_e3516 < _e3518)) <= select(_e3523, _e3510, (_e3510 > _e3523))))) && (select(0i, select(select(i32(_e3400), i32(-2147483648), (_e3400 < -2147483600f)), 2147483647i, (_e3400 > 2147483500f)), (_e3400 == _e3400)) >= 0i)) {
let _e3545 = (_e3423 * 4i);
let _e3547 = (bitcast<i32>(_e129) - 1i);
let _e3549 = select(_e3547, _e3545, (_e3545 < _e3547));
let _e3555 = global_1.member[bitcast<u32>(select(0i, _e3549, (_e3549 > 0i)))];
phi_6005_ = select(_e3555, 1f, (_e3423 == 16i));
} else {
phi_6005_ = 0f;
}
let _e3559 = phi_6005_;
let _e3565 = select(_e2851, _e3408, (_e3408 < _e2851));
let _e3571 = global_5.member[bitcast<u32>(select(0i, _e3565, (_e3565 > 0i)))];
let _e3575 = select(-1i, _e3423, (((_e3559 > 0f) || (_e2723 && (_e3559 < 0f))) && (_e2723 || (_e3571 < 1f))));
if _e2723 {
let _e3582 = select(1f, -1f, ((((_e3456 * _e3372) + (_e3457 * _e3381)) + (_e3458 * _e3390)) > 0f));
let _e3583 = (_e3372 * _e3582);
let _e3584 = (_e3381 * _e3582);
let _e3585 = (_e3390 * _e3582);
let _e3591 = -((((_e3456 * _e3583) + (_e3457 * _e3584)) + (_e3458 * _e3585)));
let _e3594 = (2f * select(0f, _e3591, (_e3591 > 0f)));
phi_6301_ = type_28(_e3533, vec3<f32>((_e3456 + (_e3583 * _e3594)), (_e3457 + (_e3584 * _e3594)), (_e3458 + (_e3585 * _e3594))), _e3391, _e3533, _e3391, _e3575);
} else {
let _e3604 = select(_e2851, _e3354, (_e3354 < _e2851));
let _e3610 = global_5.member[bitcast<u32>(select(0i, _e3604, (_e3604 > 0i)))];
let _e3611 = (_e2729 + _e3354);
let _e3613 = select(_e2851, _e3611, (_e3611 < _e2851));
let _e3619 = global_5.member[bitcast<u32>(select(0i, _e3613, (_e3613 > 0i)))];
let _e3621 = ((2i * _e2729) + _e3354);
let _e3623 = select(_e2851, _e3621, (_e3621 < _e2851));
let _e3629 = global_5.member[bitcast<u32>(select(0i, _e3623, (_e3623 > 0i)))];
let _e3632 = ((3i * _e2729) + _e3354);
let _e3634 = select(_e2851, _e3632, (_e3632 < _e2851));
let _e3640 = global_5.member[bitcast<u32>(select(0i, _e3634, (_e3634 > 0i)))];
let _e3642 = select(_e2851, _e3355, (_e3355 < _e2851));
let _e3648 = global_5.member[bitcast<u32>(select(0i, _e3642, (_e3642 > 0i)))];
let _e3650 = select(_e2851, _e3364, (_e3364 < _e2851));
let _e3656 = global_5.member[bitcast<u32>(select(0i, _e3650, (_e3650 > 0i)))];
let _e3659 = select(_e2851, _e3373, (_e3373 < _e2851));
let _e3665 = global_5.member[bitcast<u32>(select(0i, _e3659, (_e3659 > 0i)))];
let _e3667 = select(_e2851, _e3382, (_e3382 < _e2851));
let _e3673 = global_5.member[bitcast<u32>(select(0i, _e3667, (_e3667 > 0i)))];
let _e3675 = select(_e2851, _e3392, (_e3392 < _e2851));
let _e3681 = global_5.member[bitcast<u32>(select(0i, _e3675, (_e3675 > 0i)))];
phi_6301_ = type_28(vec3<f32>(_e3610, _e3619, _e3629), vec3<f32>(_e3640, _e3648, _e3656), vec3<f32>(_e3665, _e3673, _e3681), _e3533, _e3391, _e3575);
}
let _e3685 = phi_6301_;
let _e3690 = (_e3685.member.x - _e3333.member.x);
let _e3693 = (_e3685.member.y - _e3333.member.y);
let _e3696 = (_e3685.member.z - _e3333.member.z);
let _e3701 = (_e3685.member_3.x - _e3333.member_3.x);
let _e3704 = (_e3685.member_3.y - _e3333.member_3.y);
let _e3707 = (_e3685.member_3.z - _e3333.member_3.z);
let _e3712 = (((_e3701 * _e3701) + (_e3704 * _e3704)) + (_e3707 * _e3707));
let _e3715 = sqrt(select(0f, _e3712, (_e3712 > 0f)));
let _e3774 = (((_e3690 * _e3690) + (_e3693 * _e3693)) + (_e3696 * _e3696));
let _e3777 = sqrt(select(0f, _e3774, (_e3774 > 0f)));
if ((((((_e3685.member_5 >= 0i) && (_e3685.member_5 == _e3333.member_5)) && ((((_e3333.member_2.x * _e3685.member_2.x) + (_e3333.member_2.y * _e3685.member_2.y)) + (_e3333.member_2.z * _e3685.member_2.z)) > 0.70710677f)) && ((((_e3333.member_4.x * _e3685.member_4.x) + (_e3333.member_4.y * _e3685.member_4.y)) + (_e3333.member_4.z * _e3685.member_4.z)) > 0.70710677f)) && (bitcast<f32>((bitcast<u32>((((_e3701 * _e3333.member_4.x) + (_e3704 * _e3333.member_4.y)) + (_e3707 * _e3333.member_4.z))) & 2147483647u)) <= (0.5f * _e3715))) && (bitcast<f32>((bitcast<u32>((((_e3690 * _e3333.member_2.x) + (_e3693 * _e3333.member_2.y)) + (_e3696 * _e3333.member_2.z))) & 2147483647u)) <= (0.5f * select(_e3715, _e3777, (_e3777 > _e3715))))) {
let _e3783 = f32(_e3345);
phi_6469_ = vec3<f32>((_e3341.x + ((_e3685.member_1.x - _e3333.member_1.x) * _e3783)), (_e3341.y + ((_e3685.member_1.y - _e3333.member_1.y) * _e3783)), (_e3341.z + ((_e3685.member_1.z - _e3333.member_1.z) * _e3783)));
phi_6470_ = vec3<f32>((_e3343.x + (_e3690 * _e3783)), (_e3343.y + (_e3693 * _e3783)), (_e3343.z + (_e3696 * _e3783)));
phi_6471_ = (_e3347 + 1f);
} else {
phi_6469_ = _e3341;
phi_6470_ = _e3343;
phi_6471_ = _e3347;
}
let _e3817 = phi_6469_;
let _e3819 = phi_6470_;
let _e3821 = phi_6471_;
phi_5569_ = _e3817;
phi_5572_ = _e3819;
phi_5574_ = (_e3345 + 2i);
phi_5576_ = _e3821;
} else {
phi_5569_ = vec3<f32>();
phi_5572_ = vec3<f32>();
phi_5574_ = i32();
phi_5576_ = f32();
}
let _e3824 = phi_5569_;
let _e3826 = phi_5572_;
let _e3828 = phi_5574_;
let _e3830 = phi_5576_;
continue;
continuing {
phi_5568_ = _e3824;
phi_5571_ = _e3826;
phi_5573_ = _e3828;
phi_5575_ = _e3830;
break if !(_e3348);
}
}
let _e3833 = local_12;
let _e3836 = local_13;
let _e3838 = (1f / select(1f, _e3836, (_e3833 > 1f)));
if (_e3335 == 0i) {
let _e3841 = local_14;
let _e3846 = type_29((_e3841 * _e3838), _e3337.member_1, _e3337.member_2, _e3337.member_3);
let _e3848 = local_15;
phi_6491_ = type_29(_e3846.member, _e3846.member_1, (_e3848 * _e3838), _e3846.member_3);
} else {
let _e3855 = local_16;
let _e3860 = type_29(_e3337.member, (_e3855 * _e3838), _e3337.member_2, _e3337.member_3);
let _e3862 = local_17;
phi_6491_ = type_29(_e3860.member, _e3860.member_1, _e3860.member_2, (_e3862 * _e3838));
}
let _e3869 = phi_6491_;
phi_5556_ = (_e3335 + 1i);
phi_5559_ = _e3869;
} else {
phi_5556_ = i32();
phi_5559_ = type_29();
}
let _e3872 = phi_5556_;
let _e3874 = phi_5559_;
continue;
continuing {
phi_5555_ = _e3872;
phi_5558_ = _e3874;
break if !(_e3338);
}
}
let _e3877 = local_18;
let _e3906 = type_27(_e3193.member, _e3193.member_1, _e3877.member, _e3193.member_3, _e3193.member_4, _e3193.member_5, _e3193.member_6, _e3193.member_7, _e3193.member_8, _e3193.member_9, _e3193.member_10, _e3193.member_11, _e3193.member_12, _e3193.member_13, _e3193.member_14, _e3193.member_15, _e3193.member_16, _e3193.member_17, _e3193.member_18, _e3193.member_19, _e3193.member_20, _e3193.member_21, _e3193.member_22, _e3193.member_23, _e3193.member_24, _e3193.member_25, _e3193.member_26, _e3193.member_27);
let _e3908 = local_19;
let _e3937 = type_27(_e3906.member, _e3906.member_1, _e3906.member_2, _e3908.member_1, _e3906.member_4, _e3906.member_5, _e3906.member_6, _e3906.member_7, _e3906.member_8, _e3906.member_9, _e3906.member_10, _e3906.member_11, _e3906.member_12, _e3906.member_13, _e3906.member_14, _e3906.member_15, _e3906.member_16, _e3906.member_17, _e3906.member_18, _e3906.member_19, _e3906.member_20, _e3906.member_21, _e3906.member_22, _e3906.member_23, _e3906.member_24, _e3906.member_25, _e3906.member_26, _e3906.member_27);
let _e3939 = local_20;
let _e3968 = type_27(_e3937.member, _e3937.member_1, _e3937.member_2, _e3937.member_3, _e3939.member_2, _e3937.member_5, _e3937.member_6, _e3937.member_7, _e3937.member_8, _e3937.member_9, _e3937.member_10, _e3937.member_11, _e3937.member_12, _e3937.member_13, _e3937.member_14, _e3937.member_15, _e3937.member_16, _e3937.member_17, _e3937.member_18, _e3937.member_19, _e3937.member_20, _e3937.member_21, _e3937.member_22, _e3937.member_23, _e3937.member_24, _e3937.member_25, _e3937.member_26, _e3937.member_27);
let _e3970 = local_21;
let _e3999 = type_27(_e3968.member, _e3968.member_1, _e3968.member_2, _e3968.member_3, _e3968.member_4, _e3970.member_3, _e3968.member_6, _e3968.member_7, _e3968.member_8, _e3968.member_9, _e3968.member_10, _e3968.member_11, _e3968.member_12, _e3968.member_13, _e3968.member_14, _e3968.member_15, _e3968.member_16, _e3968.member_17, _e3968.member_18, _e3968.member_19, _e3968.member_20, _e3968.member_21, _e3968.member_22, _e3968.member_23, _e3968.member_24, _e3968.member_25, _e3968.member_26, _e3968.member_27);
let _e4027 = type_27(_e3999.member, _e3999.member_1, _e3999.member_2, _e3999.member_3, _e3999.member_4, _e3999.member_5, _e2682, _e3999.member_7, _e3999.member_8, _e3999.member_9, _e3999.member_10, _e3999.member_11, _e3999.member_12, _e3999.member_13, _e3999.member_14, _e3999.member_15, _e3999.member_16, _e3999.member_17, _e3999.member_18, _e3999.member_19, _e3999.member_20, _e3999.member_21, _e3999.member_22, _e3999.member_23, _e3999.member_24, _e3999.member_25, _e3999.member_26, _e3999.member_27);
let _e4055 = type_27(_e4027.member, _e4027.member_1, _e4027.member_2, _e4027.member_3, _e4027.member_4, _e4027.member_5, _e4027.member_6, _e4027.member_7, _e4027.member_8, _e3049, _e4027.member_10, _e4027.member_11, _e4027.member_12, _e4027.member_13, _e4027.member_14, _e4027.member_15, _e4027.member_16, _e4027.member_17, _e4027.member_18, _e4027.member_19, _e4027.member_20, _e4027.member_21, _e4027.member_22, _e4027.member_23, _e4027.member_24, _e4027.member_25, _e4027.member_26, _e4027.member_27);
let _e4083 = type_27(_e4055.member, _e4055.member_1, _e4055.member_2, _e4055.member_3, _e4055.member_4, _e4055.member_5, _e4055.member_6, _e4055.member_7, _e4055.member_8, _e4055.member_9, _e3050, _e4055.member_11, _e4055.member_12, _e4055.member_13, _e4055.member_14, _e4055.member_15, _e4055.member_16, _e4055.member_17, _e4055.member_18, _e4055.member_19, _e4055.member_20, _e4055.member_21, _e4055.member_22, _e4055.member_23, _e4055.member_24, _e4055.member_25, _e4055.member_26, _e4055.member_27);
phi_7610_ = type_27(_e4083.member, _e4083.member_1, _e4083.member_2, _e4083.member_3, _e4083.member_4, _e4083.member_5, _e4083.member_6, _e4083.member_7, _e4083.member_8, _e4083.member_9, _e4083.member_10, _e4083.member_11, _e4083.member_12, _e4083.member_13, _e4083.member_14, _e4083.member_15, _e4083.member_16, _e4083.member_17, _e4083.member_18, _e4083.member_19, _e4083.member_20, _e4083.member_21, _e4083.member_22, _e4083.member_23, _e4083.member_24, _e4083.member_25, _e4083.member_26, (_e2676.member_27 + _e2688));
} else {
let _e4121 = (1f / select(_e2973.member_1.x, select(1e-12f, -1e-12f, (_e2973.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e2973.member_1.x) & 2147483647u)) < 1e-12f)));
let _e4129 = (1f / select(_e2973.member_1.y, select(1e-12f, -1e-12f, (_e2973.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e2973.member_1.y) & 2147483647u)) < 1e-12f)));
let _e4137 = (1f / select(_e2973.member_1.z, select(1e-12f, -1e-12f, (_e2973.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e2973.member_1.z) & 2147483647u)) < 1e-12f)));
let _e4139 = ((_e643.member - _e2973.member.x) * _e4121);
let _e4141 = ((_e650.member - _e2973.member.x) * _e4121);
let _e4143 = ((_e643.member_1 - _e2973.member.y) * _e4129);
let _e4145 = ((_e650.member_1 - _e2973.member.y) * _e4129);
let _e4147 = ((_e643.member_2 - _e2973.member.z) * _e4137);
let _e4149 = ((_e650.member_2 - _e2973.member.z) * _e4137);
let _e4151 = select(_e4141, _e4139, (_e4139 < _e4141));
let _e4153 = select(_e4145, _e4143, (_e4143 < _e4145));
let _e4155 = select(_e4153, _e4151, (_e4151 > _e4153));
let _e4157 = select(_e4149, _e4147, (_e4147 < _e4149));
let _e4159 = select(_e4157, _e4155, (_e4155 > _e4157));
let _e4161 = select(_e4141, _e4139, (_e4139 > _e4141));
let _e4163 = select(_e4145, _e4143, (_e4143 > _e4145));
let _e4165 = select(_e4163, _e4161, (_e4161 < _e4163));
let _e4167 = select(_e4149, _e4147, (_e4147 > _e4149));
let _e4169 = select(_e4167, _e4165, (_e4165 < _e4167));
let _e4171 = select(0f, _e4159, (_e4159 > 0f));
let _e4173 = select(_e3050, _e4169, (_e4169 < _e3050));
let _e4174 = (_e4173 > _e4171);
let _e4175 = select(0f, _e4171, _e4174);
let _e4177 = (select(0f, _e4173, _e4174) - _e4175);
if _e698 {
phi_7387_ = _e4177;
} else {
let _e4179 = (_e4177 / f32(_e697));
phi_6662_ = 0u;
phi_6665_ = 0f;
loop {
let _e4181 = phi_6662_;
let _e4183 = phi_6665_;
local_66 = _e4183;
let _e4186 = ((_e4181 < _e697) && (_e4177 > 0f));
if _e4186 {
let _e4189 = (_e4175 + (_e4179 * f32(_e4181)));
let _e4190 = (_e4189 + _e4179);
let _e4192 = (0.5f * (_e4189 + _e4190));
let _e4193 = (_e4190 - _e4189);
let _e4194 = (0.28867513f * _e4193);
let _e4195 = (_e4192 - _e4194);
let _e4205 = global_3.member.member_13.member_7;
let _e4206 = bitcast<i32>(_e4205);
let _e4210 = global_3.member.member_13.member_8;
let _e4211 = bitcast<i32>(_e4210);
let _e4215 = global_3.member.member_13.member_9;
let _e4216 = bitcast<i32>(_e4215);
let _e4217 = f32(_e4206);
let _e4219 = (_e650.member - _e643.member);
let _e4222 = (((((_e2973.member.x + (_e2973.member_1.x * _e4195)) - _e643.member) / _e4219) * _e4217) - 0.5f);
let _e4223 = (_e4217 - 1f);
let _e4225 = select(0f, _e4222, (_e4222 > 0f));
let _e4227 = select(_e4223, _e4225, (_e4225 < _e4223));
let _e4228 = f32(_e4211);
let _e4230 = (_e650.member_1 - _e643.member_1);
let _e4233 = (((((_e2973.member.y + (_e2973.member_1.y * _e4195)) - _e643.member_1) / _e4230) * _e4228) - 0.5f);
let _e4234 = (_e4228 - 1f);
let _e4236 = select(0f, _e4233, (_e4233 > 0f));
let _e4238 = select(_e4234, _e4236, (_e4236 < _e4234));
let _e4239 = f32(_e4216);
let _e4241 = (_e650.member_2 - _e643.member_2);
let _e4244 = (((((_e2973.member.z + (_e2973.member_1.z * _e4195)) - _e643.member_2) / _e4241) * _e4239) - 0.5f);
let _e4245 = (_e4239 - 1f);
let _e4247 = select(0f, _e4244, (_e4244 > 0f));
let _e4249 = select(_e4245, _e4247, (_e4247 < _e4245));
let _e4251 = select(0f, _e4227, (_e4227 > 0f));
let _e4253 = select(1e6f, _e4251, (_e4251 < 1e6f));
let _e4260 = select(0i, select(select(i32(_e4253), i32(-2147483648), (_e4253 < -2147483600f)), 2147483647i, (_e4253 > 2147483500f)), (_e4253 == _e4253));
let _e4264 = (_e4260 - select(0i, 1i, (_e4253 < f32(_e4260))));
let _e4266 = select(0f, _e4238, (_e4238 > 0f));
let _e4268 = select(1e6f, _e4266, (_e4266 < 1e6f));
let _e4275 = select(0i, select(select(i32(_e4268), i32(-2147483648), (_e4268 < -2147483600f)), 2147483647i, (_e4268 > 2147483500f)), (_e4268 == _e4268));
let _e4279 = (_e4275 - select(0i, 1i, (_e4268 < f32(_e4275))));
let _e4281 = select(0f, _e4249, (_e4249 > 0f));
let _e4283 = select(1e6f, _e4281, (_e4281 < 1e6f));
let _e4290 = select(0i, select(select(i32(_e4283), i32(-2147483648), (_e4283 < -2147483600f)), 2147483647i, (_e4283 > 2147483500f)), (_e4283 == _e4283));
let _e4294 = (_e4290 - select(0i, 1i, (_e4283 < f32(_e4290))));
let _e4298 = (_e4238 - f32(_e4279));
let _e4300 = (_e4249 - f32(_e4294));
local_2 = (_e4227 - f32(_e4264));
let _e4301 = (_e4264 + 1i);
let _e4303 = select(_e4301, 0i, (_e4301 < 0i));
if (_e4303 >= _e4206) {
phi_6806_ = (_e4206 - 1i);
} else {
phi_6806_ = _e4303;
}
let _e4307 = phi_6806_;
local_3 = (_e4307 - _e4264);
let _e4309 = (_e4279 + 1i);
let _e4311 = select(_e4309, 0i, (_e4309 < 0i));
if (_e4311 >= _e4211) {
phi_6819_ = (_e4211 - 1i);
} else {
phi_6819_ = _e4311;
}
let _e4315 = phi_6819_;
let _e4317 = ((_e4315 - _e4279) * _e4206);
let _e4318 = (_e4294 + 1i);
let _e4320 = select(_e4318, 0i, (_e4318 < 0i));
if (_e4320 >= _e4216) {
phi_6833_ = (_e4216 - 1i);
} else {
phi_6833_ = _e4320;
}
let _e4324 = phi_6833_;
let _e4331 = global_3.member.member_13.member_10;
let _e4332 = bitcast<i32>(_e4331);
let _e4337 = ((_e4332 + (((_e4294 * _e4211) + _e4279) * _e4206)) + _e4264);
let _e4339 = (bitcast<i32>(_e129) - 1i);
let _e4341 = select(_e4339, _e4337, (_e4337 < _e4339));
let _e4346 = global_1.member[bitcast<u32>(select(0i, _e4341, (_e4341 > 0i)))];
let _e4347 = local_2;
let _e4350 = local_3;
let _e4351 = (_e4337 + _e4350);
let _e4353 = select(_e4339, _e4351, (_e4351 < _e4339));
let _e4358 = global_1.member[bitcast<u32>(select(0i, _e4353, (_e4353 > 0i)))];
let _e4359 = local_2;
let _e4362 = (1f - _e4298);
let _e4364 = (_e4337 + _e4317);
let _e4366 = select(_e4339, _e4364, (_e4364 < _e4339));
let _e4371 = global_1.member[bitcast<u32>(select(0i, _e4366, (_e4366 > 0i)))];
let _e4372 = local_2;
let _e4375 = local_3;
let _e4376 = (_e4364 + _e4375);
let _e4378 = select(_e4339, _e4376, (_e4376 < _e4339));
let _e4383 = global_1.member[bitcast<u32>(select(0i, _e4378, (_e4378 > 0i)))];
let _e4384 = local_2;
let _e4389 = (_e4337 + (((_e4324 - _e4294) * _e4206) * _e4211));
let _e4391 = select(_e4339, _e4389, (_e4389 < _e4339));
let _e4396 = global_1.member[bitcast<u32>(select(0i, _e4391, (_e4391 > 0i)))];
let _e4397 = local_2;
let _e4400 = local_3;
let _e4401 = (_e4389 + _e4400);
let _e4403 = select(_e4339, _e4401, (_e4401 < _e4339));
let _e4408 = global_1.member[bitcast<u32>(select(0i, _e4403, (_e4403 > 0i)))];
let _e4409 = local_2;
let _e4413 = (_e4389 + _e4317);
let _e4415 = select(_e4339, _e4413, (_e4413 < _e4339));
let _e4420 = global_1.member[bitcast<u32>(select(0i, _e4415, (_e4415 > 0i)))];
let _e4421 = local_2;
let _e4424 = local_3;
let _e4425 = (_e4413 + _e4424);
let _e4427 = select(_e4339, _e4425, (_e4425 < _e4339));
let _e4432 = global_1.member[bitcast<u32>(select(0i, _e4427, (_e4427 > 0i)))];
let _e4433 = local_2;
let _e4442 = (_e4192 + _e4194);
let _e4452 = (((((_e2973.member.x + (_e2973.member_1.x * _e4442)) - _e643.member) / _e4219) * _e4217) - 0.5f);
let _e4454 = select(0f, _e4452, (_e4452 > 0f));
let _e4456 = select(_e4223, _e4454, (_e4454 < _e4223));
let _e4460 = (((((_e2973.member.y + (_e2973.member_1.y * _e4442)) - _e643.member_1) / _e4230) * _e4228) - 0.5f);
let _e4462 = select(0f, _e4460, (_e4460 > 0f));
let _e4464 = select(_e4234, _e4462, (_e4462 < _e4234));
let _e4468 = (((((_e2973.member.z + (_e2973.member_1.z * _e4442)) - _e643.member_2) / _e4241) * _e4239) - 0.5f);
let _e4470 = select(0f, _e4468, (_e4468 > 0f));
let _e4472 = select(_e4245, _e4470, (_e4470 < _e4245));
let _e4474 = select(0f, _e4456, (_e4456 > 0f));
let _e4476 = select(1e6f, _e4474, (_e4474 < 1e6f));
let _e4483 = select(0i, select(select(i32(_e4476), i32(-2147483648), (_e4476 < -2147483600f)), 2147483647i, (_e4476 > 2147483500f)), (_e4476 == _e4476));
let _e4487 = (_e4483 - select(0i, 1i, (_e4476 < f32(_e4483))));
let _e4489 = select(0f, _e4464, (_e4464 > 0f));
let _e4491 = select(1e6f, _e4489, (_e4489 < 1e6f));
let _e4498 = select(0i, select(select(i32(_e4491), i32(-2147483648), (_e4491 < -2147483600f)), 2147483647i, (_e4491 > 2147483500f)), (_e4491 == _e4491));
let _e4502 = (_e4498 - select(0i, 1i, (_e4491 < f32(_e4498))));
let _e4504 = select(0f, _e4472, (_e4472 > 0f));
let _e4506 = select(1e6f, _e4504, (_e4504 < 1e6f));
let _e4513 = select(0i, select(select(i32(_e4506), i32(-2147483648), (_e4506 < -2147483600f)), 2147483647i, (_e4506 > 2147483500f)), (_e4506 == _e4506));
let _e4517 = (_e4513 - select(0i, 1i, (_e4506 < f32(_e4513))));
let _e4521 = (_e4464 - f32(_e4502));
let _e4523 = (_e4472 - f32(_e4517));
local = (_e4456 - f32(_e4487));
let _e4524 = (_e4487 + 1i);
let _e4526 = select(_e4524, 0i, (_e4524 < 0i));
if (_e4526 >= _e4206) {
phi_7155_ = (_e4206 - 1i);
} else {
phi_7155_ = _e4526;
}
let _e4530 = phi_7155_;
local_1 = (_e4530 - _e4487);
let _e4532 = (_e4502 + 1i);
let _e4534 = select(_e4532, 0i, (_e4532 < 0i));
if (_e4534 >= _e4211) {
phi_7168_ = (_e4211 - 1i);
} else {
phi_7168_ = _e4534;
}
let _e4538 = phi_7168_;
let _e4540 = ((_e4538 - _e4502) * _e4206);
let _e4541 = (_e4517 + 1i);
let _e4543 = select(_e4541, 0i, (_e4541 < 0i));
if (_e4543 >= _e4216) {
phi_7182_ = (_e4216 - 1i);
} else {
phi_7182_ = _e4543;
}
let _e4547 = phi_7182_;
let _e4555 = ((_e4332 + (((_e4517 * _e4211) + _e4502) * _e4206)) + _e4487);
let _e4557 = select(_e4339, _e4555, (_e4555 < _e4339));
let _e4562 = global_1.member[bitcast<u32>(select(0i, _e4557, (_e4557 > 0i)))];
let _e4563 = local;
let _e4566 = local_1;
let _e4567 = (_e4555 + _e4566);
let _e4569 = select(_e4339, _e4567, (_e4567 < _e4339));
let _e4574 = global_1.member[bitcast<u32>(select(0i, _e4569, (_e4569 > 0i)))];
let _e4575 = local;
let _e4578 = (1f - _e4521);
let _e4580 = (_e4555 + _e4540);
let _e4582 = select(_e4339, _e4580, (_e4580 < _e4339));
let _e4587 = global_1.member[bitcast<u32>(select(0i, _e4582, (_e4582 > 0i)))];
let _e4588 = local;
let _e4591 = local_1;
let _e4592 = (_e4580 + _e4591);
let _e4594 = select(_e4339, _e4592, (_e4592 < _e4339));
let _e4599 = global_1.member[bitcast<u32>(select(0i, _e4594, (_e4594 > 0i)))];
let _e4600 = local;
let _e4605 = (_e4555 + (((_e4547 - _e4517) * _e4206) * _e4211));
let _e4607 = select(_e4339, _e4605, (_e4605 < _e4339));
let _e4612 = global_1.member[bitcast<u32>(select(0i, _e4607, (_e4607 > 0i)))];
let _e4613 = local;
let _e4616 = local_1;
let _e4617 = (_e4605 + _e4616);
let _e4619 = select(_e4339, _e4617, (_e4617 < _e4339));
let _e4624 = global_1.member[bitcast<u32>(select(0i, _e4619, (_e4619 > 0i)))];
let _e4625 = local;
let _e4629 = (_e4605 + _e4540);
let _e4631 = select(_e4339, _e4629, (_e4629 < _e4339));
let _e4636 = global_1.member[bitcast<u32>(select(0i, _e4631, (_e4631 > 0i)))];
let _e4637 = local;
let _e4640 = local_1;
let _e4641 = (_e4629 + _e4640);
let _e4643 = select(_e4339, _e4641, (_e4641 < _e4339));
let _e4648 = global_1.member[bitcast<u32>(select(0i, _e4643, (_e4643 > 0i)))];
let _e4649 = local;
phi_6663_ = (_e4181 + 1u);
phi_6666_ = (_e4183 + ((0.5f * (((((((_e4346 * (1f - _e4347)) + (_e4358 * _e4359)) * _e4362) + (((_e4371 * (1f - _e4372)) + (_e4383 * _e4384)) * _e4298)) * (1f - _e4300)) + (((((_e4396 * (1f - _e4397)) + (_e4408 * _e4409)) * _e4362) + (((_e4420 * (1f - _e4421)) + (_e4432 * _e4433)) * _e4298)) * _e4300)) + ((((((_e4562 * (1f - _e4563)) + (_e4574 * _e4575)) * _e4578) + (((_e4587 * (1f - _e4588)) + (_e4599 * _e4600)) * _e4521)) * (1f - _e4523)) + (((((_e4612 * (1f - _e4613)) + (_e4624 * _e4625)) * _e4578) + (((_e4636 * (1f - _e4637)) + (_e4648 * _e4649)) * _e4521)) * _e4523)))) * _e4193));
} else {
phi_6663_ = u32();
phi_6666_ = f32();
}
let _e4664 = phi_6663_;
let _e4666 = phi_6666_;
continue;
continuing {
phi_6662_ = _e4664;
phi_6665_ = _e4666;
break if !(_e4186);
}
}
let _e5393 = local_66;
phi_7387_ = _e5393;
}
let _e4669 = phi_7387_;
let _e4671 = -((_e1194.member * _e4669));
let _e4673 = select(-87f, _e4671, (_e4671 > -87f));
let _e4675 = select(88f, _e4673, (_e4673 < 88f));
let _e4677 = ((_e4675 * 1.442695f) + 0.5f);
let _e4679 = select(-127f, _e4677, (_e4677 > -127f));
let _e4681 = select(128f, _e4679, (_e4679 < 128f));
let _e4688 = select(0i, select(select(i32(_e4681), i32(-2147483648), (_e4681 < -2147483600f)), 2147483647i, (_e4681 > 2147483500f)), (_e4681 == _e4681));
let _e4692 = (_e4688 - select(0i, 1i, (_e4681 < f32(_e4688))));
let _e4693 = f32(_e4692);
let _e4697 = ((_e4675 - (_e4693 * 0.6933594f)) - (_e4693 * -2.1219444e-4f));
let _e4719 = -((_e1194.member_1 * _e4669));
let _e4721 = select(-87f, _e4719, (_e4719 > -87f));
let _e4723 = select(88f, _e4721, (_e4721 < 88f));
let _e4725 = ((_e4723 * 1.442695f) + 0.5f);
let _e4727 = select(-127f, _e4725, (_e4725 > -127f));
let _e4729 = select(128f, _e4727, (_e4727 < 128f));
let _e4736 = select(0i, select(select(i32(_e4729), i32(-2147483648), (_e4729 < -2147483600f)), 2147483647i, (_e4729 > 2147483500f)), (_e4729 == _e4729));
let _e4740 = (_e4736 - select(0i, 1i, (_e4729 < f32(_e4736))));
let _e4741 = f32(_e4740);
let _e4745 = ((_e4723 - (_e4741 * 0.6933594f)) - (_e4741 * -2.1219444e-4f));
let _e4767 = -((_e1194.member_2 * _e4669));
let _e4769 = select(-87f, _e4767, (_e4767 > -87f));
let _e4771 = select(88f, _e4769, (_e4769 < 88f));
let _e4773 = ((_e4771 * 1.442695f) + 0.5f);
let _e4775 = select(-127f, _e4773, (_e4773 > -127f));
let _e4777 = select(128f, _e4775, (_e4775 < 128f));
let _e4784 = select(0i, select(select(i32(_e4777), i32(-2147483648), (_e4777 < -2147483600f)), 2147483647i, (_e4777 > 2147483500f)), (_e4777 == _e4777));
let _e4788 = (_e4784 - select(0i, 1i, (_e4777 < f32(_e4784))));
let _e4789 = f32(_e4788);
let _e4793 = ((_e4771 - (_e4789 * 0.6933594f)) - (_e4789 * -2.1219444e-4f));
let _e4819 = ((((_e2682.x * ((1f + (_e4697 * (1f + (_e4697 * (0.5f + (_e4697 * (0.16666667f + (_e4697 * (0.041666668f + (_e4697 * (0.008333334f + (_e4697 * (0.001388889f + (_e4697 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4692 + 127i)) << bitcast<u32>(23i))))) + (_e2682.y * ((1f + (_e4745 * (1f + (_e4745 * (0.5f + (_e4745 * (0.16666667f + (_e4745 * (0.041666668f + (_e4745 * (0.008333334f + (_e4745 * (0.001388889f + (_e4745 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4740 + 127i)) << bitcast<u32>(23i)))))) + (_e2682.z * ((1f + (_e4793 * (1f + (_e4793 * (0.5f + (_e4793 * (0.16666667f + (_e4793 * (0.041666668f + (_e4793 * (0.008333334f + (_e4793 * (0.001388889f + (_e4793 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4788 + 127i)) << bitcast<u32>(23i)))))) * _e1344);
let _e4850 = type_27(_e2676.member, _e2676.member_1, _e2676.member_2, _e2676.member_3, _e2676.member_4, _e2676.member_5, _e2676.member_6, _e2676.member_7, _e2676.member_8, _e2676.member_9, _e2676.member_10, _e2676.member_11, _e2676.member_12, _e2676.member_13, _e2676.member_14, _e2676.member_15, _e2676.member_16, _e2676.member_17, _e2676.member_18, _e2676.member_19, _e2676.member_20, _e2676.member_21, _e2676.member_22, _e2676.member_23, _e2676.member_24, _e2676.member_25, (_e2676.member_26 + (_e2688 - _e4819)), _e2676.member_27);
let _e4851 = (_e3049 == -1i);
let _e4882 = type_27(_e4850.member, _e4850.member_1, _e4850.member_2, _e4850.member_3, _e4850.member_4, _e4850.member_5, _e4850.member_6, _e4850.member_7, _e4850.member_8, _e4850.member_9, _e4850.member_10, _e4850.member_11, _e4850.member_12, _e4850.member_13, _e4850.member_14, _e4850.member_15, _e4850.member_16, _e4850.member_17, _e4850.member_18, _e4850.member_19, _e4850.member_20, _e4850.member_21, _e4850.member_22, (_e2676.member_23 + select(0f, _e4819, _e4851)), _e4850.member_24, _e4850.member_25, _e4850.member_26, _e4850.member_27);
phi_7610_ = type_27(_e4882.member, _e4882.member_1, _e4882.member_2, _e4882.member_3, _e4882.member_4, _e4882.member_5, _e4882.member_6, _e4882.member_7, _e4882.member_8, _e4882.member_9, _e4882.member_10, _e4882.member_11, _e4882.member_12, _e4882.member_13, _e4882.member_14, _e4882.member_15, _e4882.member_16, _e4882.member_17, _e4882.member_18, _e4882.member_19, _e4882.member_20, _e4882.member_21, _e4882.member_22, _e4882.member_23, (_e2676.member_24 + select(_e4819, 0f, _e4851)), _e4882.member_25, _e4882.member_26, _e4882.member_27);
}
let _e4915 = phi_7610_;
phi_7611_ = _e4915;
} else {
phi_7611_ = _e2676;
}
let _e4917 = phi_7611_;
phi_7612_ = _e4917;
}
let _e4919 = phi_7612_;
phi_3954_ = _e4919;
phi_3957_ = (_e2678 + 1i);
} else {
phi_3954_ = type_27();
phi_3957_ = i32();
}
let _e4922 = phi_3954_;
let _e4924 = phi_3957_;
continue;
continuing {
phi_3953_ = _e4922;
phi_3956_ = _e4924;
break if !(_e2679);
}
}
let _e4927 = local_22;
let _e4931 = local_23;
let _e4935 = local_24;
let _e4939 = local_25;
let _e4943 = local_26;
let _e4947 = local_27;
let _e4951 = local_28;
let _e4955 = local_29;
let _e4959 = local_30;
let _e4963 = local_31;
let _e4967 = local_32;
let _e4971 = local_33;
let _e4975 = local_34;
let _e4979 = local_35;
let _e4983 = local_36;
let _e4987 = local_37;
let _e4991 = local_38;
let _e4995 = local_39;
let _e4999 = local_40;
let _e5003 = local_41;
let _e5007 = local_42;
let _e5011 = local_43;
let _e5015 = local_44;
let _e5019 = local_45;
let _e5023 = local_46;
let _e5026 = local_47;
let _e5030 = local_48;
let _e5034 = local_49;
let _e5037 = local_50;
let _e5040 = local_51;
let _e5043 = local_52;
let _e5047 = local_53;
let _e5051 = local_54;
let _e5055 = local_55;
let _e5059 = local_56;
let _e5063 = local_57;
let _e5067 = local_58;
let _e5071 = local_59;
let _e5074 = local_60;
let _e5077 = local_61;
let _e5080 = local_62;
let _e5083 = local_63;
phi_7669_ = array<f32, 42>();
phi_7670_ = array<f32, 42>(_e4927.member.x, _e4931.member.y, _e4935.member.z, _e4939.member_1.x, _e4943.member_1.y, _e4947.member_1.z, _e4951.member_2.x, _e4955.member_2.y, _e4959.member_2.z, _e4963.member_3.x, _e4967.member_3.y, _e4971.member_3.z, _e4975.member_4.x, _e4979.member_4.y, _e4983.member_4.z, _e4987.member_5.x, _e4991.member_5.y, _e4995.member_5.z, _e4999.member_6.x, _e5003.member_6.y, _e5007.member_6.z, f32(_e5011.member_7), f32(_e5015.member_8), f32(_e5019.member_9), _e5023.member_10, f32(_e5026.member_11), f32(_e5030.member_12), _e5034.member_13, _e5037.member_14, _e5040.member_15, f32(_e5043.member_16), f32(_e5047.member_17), f32(_e5051.member_18), f32(_e5055.member_19), f32(_e5059.member_20), f32(_e5063.member_21), f32(_e5067.member_22), _e5071.member_23, _e5074.member_24, _e5077.member_25, _e5080.member_26, _e5083.member_27);
}
let _e5087 = phi_7669_;
let _e5089 = phi_7670_;
phi_7671_ = _e5087;
phi_7672_ = _e5089;
phi_7673_ = _e2214;
}
let _e5091 = phi_7671_;
let _e5093 = phi_7672_;
let _e5095 = phi_7673_;
phi_7677_ = _e5091;
phi_7678_ = _e5093;
phi_7679_ = _e5095;
}
let _e5097 = phi_7677_;
let _e5099 = phi_7678_;
let _e5101 = phi_7679_;
if _e5101 {
phi_7683_ = _e5097;
} else {
phi_7683_ = _e5099;
}
let _e5103 = phi_7683_;
global_2.member[_e141] = _e5103[0];
global_2.member[(_e139 + _e141)] = _e5103[1];
global_2.member[((2u * _e139) + _e141)] = _e5103[2];
global_2.member[((3u * _e139) + _e141)] = _e5103[3];
global_2.member[((4u * _e139) + _e141)] = _e5103[4];
global_2.member[((5u * _e139) + _e141)] = _e5103[5];
global_2.member[((6u * _e139) + _e141)] = _e5103[6];
global_2.member[((7u * _e139) + _e141)] = _e5103[7];
global_2.member[((8u * _e139) + _e141)] = _e5103[8];
global_2.member[((9u * _e139) + _e141)] = _e5103[9];
global_2.member[((10u * _e139) + _e141)] = _e5103[10];
global_2.member[((11u * _e139) + _e141)] = _e5103[11];
global_2.member[((12u * _e139) + _e141)] = _e5103[12];
global_2.member[((13u * _e139) + _e141)] = _e5103[13];
global_2.member[((14u * _e139) + _e141)] = _e5103[14];
global_2.member[((15u * _e139) + _e141)] = _e5103[15];
global_2.member[((16u * _e139) + _e141)] = _e5103[16];
global_2.member[((17u * _e139) + _e141)] = _e5103[17];
global_2.member[((18u * _e139) + _e141)] = _e5103[18];
global_2.member[((19u * _e139) + _e141)] = _e5103[19];
global_2.member[((20u * _e139) + _e141)] = _e5103[20];
global_2.member[((21u * _e139) + _e141)] = _e5103[21];
global_2.member[((22u * _e139) + _e141)] = _e5103[22];
global_2.member[((23u * _e139) + _e141)] = _e5103[23];
global_2.member[((24u * _e139) + _e141)] = _e5103[24];
global_2.member[((25u * _e139) + _e141)] = _e5103[25];
global_2.member[((26u * _e139) + _e141)] = _e5103[26];
global_2.member[((27u * _e139) + _e141)] = _e5103[27];
global_2.member[((28u * _e139) + _e141)] = _e5103[28];
global_2.member[((29u * _e139) + _e141)] = _e5103[29];
global_2.member[((30u * _e139) + _e141)] = _e5103[30];
global_2.member[((31u * _e139) + _e141)] = _e5103[31];
global_2.member[((32u * _e139) + _e141)] = _e5103[32];
global_2.member[((33u * _e139) + _e141)] = _e5103[33];
global_2.member[((34u * _e139) + _e141)] = _e5103[34];
global_2.member[((35u * _e139) + _e141)] = _e5103[35];
global_2.member[((36u * _e139) + _e141)] = _e5103[36];
global_2.member[((37u * _e139) + _e141)] = _e5103[37];
global_2.member[((38u * _e139) + _e141)] = _e5103[38];
global_2.member[((39u * _e139) + _e141)] = _e5103[39];
global_2.member[((40u * _e139) + _e141)] = _e5103[40];
global_2.member[((41u * _e139) + _e141)] = _e5103[41];
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
