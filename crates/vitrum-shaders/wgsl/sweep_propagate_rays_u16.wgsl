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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: vec3<f32>,
member_1: vec3<f32>,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_31 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
struct type_33 {
member: array<type_24>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_16;
@group(0) @binding(3)
var<storage> global_2: type_16;
@group(0) @binding(4)
var<storage> global_3: type_16;
@group(0) @binding(6)
var<storage, read_write> global_4: type_11;
@group(0) @binding(0)
var<storage> global_5: type_33;
@group(0) @binding(5)
var<storage> global_6: type_11;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var local_6: type_28;
var local_7: vec3<f32>;
var phi_580_: u32;
var phi_583_: bool;
var phi_585_: array<f32, 18>;
var phi_3878_: type_29;
var phi_4656_: type_30;
var phi_5374_: f32;
var phi_5763_: type_5;
var phi_7321_: type_31;
var phi_8074_: vec3<f32>;
var phi_8304_: type_25;
var phi_8622_: vec3<f32>;
var phi_8931_: f32;
var phi_8932_: f32;
var phi_8933_: f32;
var phi_8934_: bool;
var phi_8994_: array<f32, 18>;
var phi_581_: u32;
var phi_584_: bool;
var phi_586_: array<f32, 18>;
var phi_9077_: bool;
var local_8: bool;
var local_9: array<f32, 18>;
var local_10: array<f32, 18>;
var local_11: array<f32, 18>;
var local_12: array<f32, 18>;
var local_13: array<f32, 18>;
var local_14: array<f32, 18>;
var local_15: array<f32, 18>;
var local_16: array<f32, 18>;
var local_17: array<f32, 18>;
var local_18: array<f32, 18>;
var local_19: array<f32, 18>;
var local_20: array<f32, 18>;
var local_21: array<f32, 18>;
var local_22: array<f32, 18>;
var local_23: array<f32, 18>;
var local_24: array<f32, 18>;
var local_25: array<f32, 18>;
var local_26: array<f32, 18>;
switch bitcast<i32>(0u) {
default: {
let _e112 = global;
let _e114 = arrayLength((&global_5.member));
let _e117 = arrayLength((&global_1.member));
let _e121 = arrayLength((&global_3.member));
if (0u < _e114) {
} else {
break;
}
let _e131 = global_5.member[0u].member_2;
let _e135 = global_5.member[0u].member;
let _e143 = (_e112.x + _e131.member);
let _e145 = (_e112.y + _e131.member_1);
if (_e143 < _e131.member_2) {
if (_e145 < _e131.member_3) {
let _e148 = (_e135.member * _e135.member_1);
let _e150 = ((_e145 * _e135.member) + _e143);
let _e151 = bitcast<i32>(_e150);
let _e153 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e155 = select(_e153, _e151, (_e151 < _e153));
let _e161 = global_4.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e162 = (_e148 + _e150);
let _e163 = bitcast<i32>(_e162);
let _e165 = select(_e153, _e163, (_e163 < _e153));
let _e171 = global_4.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e173 = ((2u * _e148) + _e150);
let _e174 = bitcast<i32>(_e173);
let _e176 = select(_e153, _e174, (_e174 < _e153));
let _e182 = global_4.member[bitcast<u32>(select(0i, _e176, (_e176 > 0i)))];
let _e184 = ((3u * _e148) + _e150);
let _e185 = bitcast<i32>(_e184);
let _e187 = select(_e153, _e185, (_e185 < _e153));
let _e193 = global_4.member[bitcast<u32>(select(0i, _e187, (_e187 > 0i)))];
let _e195 = ((4u * _e148) + _e150);
let _e196 = bitcast<i32>(_e195);
let _e198 = select(_e153, _e196, (_e196 < _e153));
let _e204 = global_4.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e206 = ((5u * _e148) + _e150);
let _e207 = bitcast<i32>(_e206);
let _e209 = select(_e153, _e207, (_e207 < _e153));
let _e215 = global_4.member[bitcast<u32>(select(0i, _e209, (_e209 > 0i)))];
let _e217 = ((6u * _e148) + _e150);
let _e218 = bitcast<i32>(_e217);
let _e220 = select(_e153, _e218, (_e218 < _e153));
let _e226 = global_4.member[bitcast<u32>(select(0i, _e220, (_e220 > 0i)))];
let _e228 = ((7u * _e148) + _e150);
let _e229 = bitcast<i32>(_e228);
let _e231 = select(_e153, _e229, (_e229 < _e153));
let _e237 = global_4.member[bitcast<u32>(select(0i, _e231, (_e231 > 0i)))];
let _e239 = ((8u * _e148) + _e150);
let _e240 = bitcast<i32>(_e239);
let _e242 = select(_e153, _e240, (_e240 < _e153));
let _e248 = global_4.member[bitcast<u32>(select(0i, _e242, (_e242 > 0i)))];
let _e250 = ((9u * _e148) + _e150);
let _e251 = bitcast<i32>(_e250);
let _e253 = select(_e153, _e251, (_e251 < _e153));
let _e259 = global_4.member[bitcast<u32>(select(0i, _e253, (_e253 > 0i)))];
let _e261 = ((10u * _e148) + _e150);
let _e262 = bitcast<i32>(_e261);
let _e264 = select(_e153, _e262, (_e262 < _e153));
let _e270 = global_4.member[bitcast<u32>(select(0i, _e264, (_e264 > 0i)))];
let _e272 = ((11u * _e148) + _e150);
let _e273 = bitcast<i32>(_e272);
let _e275 = select(_e153, _e273, (_e273 < _e153));
let _e281 = global_4.member[bitcast<u32>(select(0i, _e275, (_e275 > 0i)))];
let _e283 = ((12u * _e148) + _e150);
let _e284 = bitcast<i32>(_e283);
let _e286 = select(_e153, _e284, (_e284 < _e153));
let _e292 = global_4.member[bitcast<u32>(select(0i, _e286, (_e286 > 0i)))];
let _e294 = ((13u * _e148) + _e150);
let _e295 = bitcast<i32>(_e294);
let _e297 = select(_e153, _e295, (_e295 < _e153));
let _e303 = global_4.member[bitcast<u32>(select(0i, _e297, (_e297 > 0i)))];
let _e305 = ((14u * _e148) + _e150);
let _e306 = bitcast<i32>(_e305);
let _e308 = select(_e153, _e306, (_e306 < _e153));
let _e314 = global_4.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e316 = ((15u * _e148) + _e150);
let _e317 = bitcast<i32>(_e316);
let _e319 = select(_e153, _e317, (_e317 < _e153));
let _e325 = global_4.member[bitcast<u32>(select(0i, _e319, (_e319 > 0i)))];
let _e327 = ((16u * _e148) + _e150);
let _e328 = bitcast<i32>(_e327);
let _e330 = select(_e153, _e328, (_e328 < _e153));
let _e336 = global_4.member[bitcast<u32>(select(0i, _e330, (_e330 > 0i)))];
let _e338 = ((17u * _e148) + _e150);
let _e339 = bitcast<i32>(_e338);
let _e341 = select(_e153, _e339, (_e339 < _e153));
let _e347 = global_4.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
phi_580_ = 0u;
phi_583_ = false;
phi_585_ = array<f32, 18>(_e161, _e171, _e182, _e193, _e204, _e215, _e226, _e237, _e248, _e259, _e270, _e281, _e292, _e303, _e314, _e325, _e336, _e347);
loop {
let _e350 = phi_580_;
let _e352 = phi_583_;
let _e354 = phi_585_;
local_8 = _e352;
local_9 = _e354;
local_10 = _e354;
local_11 = _e354;
local_12 = _e354;
local_13 = _e354;
local_14 = _e354;
local_15 = _e354;
local_16 = _e354;
local_17 = _e354;
local_18 = _e354;
local_19 = _e354;
local_20 = _e354;
local_21 = _e354;
local_22 = _e354;
local_23 = _e354;
local_24 = _e354;
local_25 = _e354;
local_26 = _e354;
let _e355 = (_e350 < _e114);
if _e355 {
if _e355 {
} else {
phi_9077_ = true;
break;
}
let _e363 = global_5.member[_e350].member_5.member_2;
let _e364 = (_e363 / _e354[4]);
let _e369 = global_5.member[_e350].member_5.member;
let _e372 = ((_e369 - _e354[16]) / _e354[4]);
let _e375 = (_e354[0] + (_e354[2] * _e372));
let _e378 = (_e354[1] + (_e354[3] * _e372));
let _e380 = (_e375 + (_e354[2] * _e364));
let _e382 = (_e378 + (_e354[3] * _e364));
let _e387 = global_5.member[_e350].member_5.member_1;
let _e393 = global_5.member[_e350].member_13.member.member;
let _e404 = ((((_e393.member.member * _e375) + (_e393.member.member_1 * _e378)) + (_e393.member.member_2 * _e369)) + _e393.member_1);
let _e410 = ((((_e393.member.member * _e380) + (_e393.member.member_1 * _e382)) + (_e393.member.member_2 * _e387)) + _e393.member_1);
let _e413 = ((_e404 > 0f) && (_e410 <= 0f));
let _e419 = global_5.member[_e350].member_13.member_1.member;
let _e430 = ((((_e419.member.member * _e375) + (_e419.member.member_1 * _e378)) + (_e419.member.member_2 * _e369)) + _e419.member_1);
let _e436 = ((((_e419.member.member * _e380) + (_e419.member.member_1 * _e382)) + (_e419.member.member_2 * _e387)) + _e419.member_1);
let _e439 = ((_e430 > 0f) && (_e436 <= 0f));
let _e440 = (_e413 || _e439);
let _e445 = global_5.member[_e350].member_6.member;
let _e456 = ((((_e445.member.member * _e375) + (_e445.member.member_1 * _e378)) + (_e445.member.member_2 * _e369)) + _e445.member_1);
let _e461 = global_5.member[_e350].member_6.member_1;
let _e472 = ((((_e461.member.member * _e375) + (_e461.member.member_1 * _e378)) + (_e461.member.member_2 * _e369)) + _e461.member_1);
let _e477 = global_5.member[_e350].member_6.member_2;
let _e488 = ((((_e477.member.member * _e375) + (_e477.member.member_1 * _e378)) + (_e477.member.member_2 * _e369)) + _e477.member_1);
let _e494 = ((((_e445.member.member * _e380) + (_e445.member.member_1 * _e382)) + (_e445.member.member_2 * _e387)) + _e445.member_1);
let _e500 = ((((_e461.member.member * _e380) + (_e461.member.member_1 * _e382)) + (_e461.member.member_2 * _e387)) + _e461.member_1);
let _e506 = ((((_e477.member.member * _e380) + (_e477.member.member_1 * _e382)) + (_e477.member.member_2 * _e387)) + _e477.member_1);
let _e511 = global_5.member[_e350].member_6.member_4;
let _e517 = global_5.member[_e350].member_6.member_3.member;
let _e518 = (_e517 - 0.5f);
let _e520 = select(-0.5f, _e494, (_e494 > -0.5f));
let _e522 = select(_e518, _e520, (_e520 < _e518));
let _e528 = global_5.member[_e350].member_6.member_3.member_1;
let _e529 = (_e528 - 0.5f);
let _e531 = select(-0.5f, _e500, (_e500 > -0.5f));
let _e533 = select(_e529, _e531, (_e531 < _e529));
let _e539 = global_5.member[_e350].member_6.member_3.member_2;
let _e540 = (_e539 - 0.5f);
let _e542 = select(-0.5f, _e506, (_e506 > -0.5f));
let _e544 = select(_e540, _e542, (_e542 < _e540));
let _e545 = (_e494 - _e456);
let _e546 = (_e500 - _e472);
let _e547 = (_e506 - _e488);
let _e550 = bitcast<f32>((bitcast<u32>(_e545) & 2147483647u));
let _e553 = bitcast<f32>((bitcast<u32>(_e546) & 2147483647u));
let _e555 = select(_e553, _e550, (_e550 > _e553));
let _e558 = bitcast<f32>((bitcast<u32>(_e547) & 2147483647u));
let _e567 = bitcast<f32>((bitcast<u32>((_e494 - _e522)) & 2147483647u));
let _e570 = bitcast<f32>((bitcast<u32>((_e500 - _e533)) & 2147483647u));
let _e572 = select(_e570, _e567, (_e567 > _e570));
let _e575 = bitcast<f32>((bitcast<u32>((_e506 - _e544)) & 2147483647u));
let _e579 = (_e522 + 0.5f);
let _e580 = (_e517 - 1f);
let _e582 = select(0f, _e579, (_e579 > 0f));
let _e584 = select(_e580, _e582, (_e582 < _e580));
let _e591 = select(0i, select(select(i32(_e584), i32(-2147483648), (_e584 < -2147483600f)), 2147483647i, (_e584 > 2147483500f)), (_e584 == _e584));
let _e600 = global_5.member[_e350].member_6.member_12;
let _e601 = (_e600 & 31u);
let _e604 = (_e533 + 0.5f);
let _e605 = (_e528 - 1f);
let _e607 = select(0f, _e604, (_e604 > 0f));
let _e609 = select(_e605, _e607, (_e607 < _e605));
let _e616 = select(0i, select(select(i32(_e609), i32(-2147483648), (_e609 < -2147483600f)), 2147483647i, (_e609 > 2147483500f)), (_e609 == _e609));
let _e623 = (_e544 + 0.5f);
let _e624 = (_e539 - 1f);
let _e626 = select(0f, _e623, (_e623 > 0f));
let _e628 = select(_e624, _e626, (_e626 < _e624));
let _e635 = select(0i, select(select(i32(_e628), i32(-2147483648), (_e628 < -2147483600f)), 2147483647i, (_e628 > 2147483500f)), (_e628 == _e628));
let _e647 = global_5.member[_e350].member_6.member_9.member;
let _e654 = global_5.member[_e350].member_6.member_9.member_1;
let _e660 = global_5.member[_e350].member_6.member_10;
let _e666 = ((bitcast<i32>(_e660) + ((_e591 - select(0i, 1i, (_e584 < f32(_e591)))) >> bitcast<u32>(_e601))) + (bitcast<i32>(_e647) * (((_e616 - select(0i, 1i, (_e609 < f32(_e616)))) >> bitcast<u32>(_e601)) + (bitcast<i32>(_e654) * ((_e635 - select(0i, 1i, (_e628 < f32(_e635)))) >> bitcast<u32>(_e601))))));
let _e668 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e670 = select(_e668, _e666, (_e666 < _e668));
let _e676 = global_2.member[bitcast<u32>(select(0i, _e670, (_e670 > 0i)))];
let _e683 = global_5.member[_e350].member_1;
let _e716 = (_e354[17] != _e369);
let _e723 = (select(0u, select(select(select(select(7u, 3u, (((((((_e456 >= 0f) && (_e456 <= _e580)) && (_e472 >= 0f)) && (_e472 <= _e605)) && (_e488 >= 0f)) && (_e488 <= _e624)) && ((((((_e494 >= 0f) && (_e494 <= _e580)) && (_e500 >= 0f)) && (_e500 <= _e605)) && (_e506 >= 0f)) && (_e506 <= _e624)))), 15u, _e716), 1u, (((_e683 & 64u) != 0u) || ((((select(_e558, _e555, (_e555 > _e558)) <= _e511) && ((select(_e575, _e572, (_e572 > _e575)) > _e511) || (_e676 != 0u))) && true) && ((_e683 & 32u) != 0u)))), 31u, _e440), (_e354[6] == 0f)) > 1u);
if _e723 {
let _e727 = global_5.member[_e350].member;
let _e729 = (_e404 - _e410);
let _e732 = (_e404 / select(1e-20f, _e729, (_e729 > 1e-20f)));
let _e733 = (_e430 - _e436);
let _e736 = (_e430 / select(1e-20f, _e733, (_e733 > 1e-20f)));
let _e740 = (_e439 && (!(_e413) || (_e736 < _e732)));
let _e747 = global_5.member[_e350].member_13.member_1.member.member;
let _e753 = global_5.member[_e350].member_13.member_1.member_1;
let _e760 = global_5.member[_e350].member_13.member.member.member;
let _e766 = global_5.member[_e350].member_13.member.member_1;
let _e785 = select(_e732, _e736, _e740);
let _e787 = (_e727.member_2 == 2u);
let _e790 = (((_e727.member_2 == 1u) || _e787) || (_e727.member_2 == 5u));
if _e790 {
let _e792 = select(-1f, _e522, (_e522 > -1f));
let _e794 = select(_e517, _e792, (_e792 < _e517));
let _e801 = select(0i, select(select(i32(_e794), i32(-2147483648), (_e794 < -2147483600f)), 2147483647i, (_e794 > 2147483500f)), (_e794 == _e794));
let _e805 = (_e801 - select(0i, 1i, (_e794 < f32(_e801))));
let _e807 = select(-1f, _e533, (_e533 > -1f));
let _e809 = select(_e528, _e807, (_e807 < _e528));
let _e816 = select(0i, select(select(i32(_e809), i32(-2147483648), (_e809 < -2147483600f)), 2147483647i, (_e809 > 2147483500f)), (_e809 == _e809));
let _e820 = (_e816 - select(0i, 1i, (_e809 < f32(_e816))));
let _e822 = select(-1f, _e544, (_e544 > -1f));
let _e824 = select(_e539, _e822, (_e822 < _e539));
let _e831 = select(0i, select(select(i32(_e824), i32(-2147483648), (_e824 < -2147483600f)), 2147483647i, (_e824 > 2147483500f)), (_e824 == _e824));
let _e835 = (_e831 - select(0i, 1i, (_e824 < f32(_e831))));
let _e840 = global_5.member[_e350].member_6.member_7;
let _e845 = global_5.member[_e350].member_6.member_8;
let _e853 = (select(0i, select(select(i32(_e528), i32(-2147483648), (_e528 < -2147483600f)), 2147483647i, (_e528 > 2147483500f)), (_e528 == _e528)) - 1i);
let _e854 = (_e820 - 1i);
let _e859 = (_e820 + 1i);
let _e862 = (_e820 + 2i);
let _e872 = (select(0i, select(select(i32(_e539), i32(-2147483648), (_e539 < -2147483600f)), 2147483647i, (_e539 > 2147483500f)), (_e539 == _e539)) - 1i);
let _e873 = (_e835 - 1i);
let _e878 = (_e835 + 1i);
let _e881 = (_e835 + 2i);
let _e890 = select(0i, select(select(i32(_e517), i32(-2147483648), (_e517 < -2147483600f)), 2147483647i, (_e517 > 2147483500f)), (_e517 == _e517));
let _e891 = (_e890 - 1i);
let _e892 = (_e805 - 1i);
let _e894 = select(0i, _e892, (_e892 > 0i));
let _e896 = select(0i, _e805, (_e805 > 0i));
let _e897 = (_e805 + 1i);
let _e899 = select(_e891, _e897, (_e897 < _e891));
let _e900 = (_e805 + 2i);
let _e903 = (_e890 - 2i);
let _e905 = select(0i, _e903, (_e903 > 0i));
let _e907 = select(_e905, _e894, (_e894 < _e905));
let _e909 = select(_e905, _e896, (_e896 < _e905));
let _e911 = select(_e905, _e899, (_e899 < _e905));
let _e930 = (select(0i, _e854, (_e854 > 0i)) * _e840);
let _e931 = (select(0i, _e820, (_e820 > 0i)) * _e840);
let _e932 = (select(_e853, _e859, (_e859 < _e853)) * _e840);
let _e933 = (select(_e853, _e862, (_e862 < _e853)) * _e840);
let _e934 = (select(0i, _e873, (_e873 > 0i)) * _e845);
let _e935 = (select(0i, _e835, (_e835 > 0i)) * _e845);
let _e936 = (select(_e872, _e878, (_e878 < _e872)) * _e845);
let _e937 = (select(_e872, _e881, (_e881 < _e872)) * _e845);
local_6 = type_28(array<i32, 4>(_e907, _e909, _e911, 0i), array<u32, 6>(bitcast<u32>(((_e894 - _e907) * 16i)), bitcast<u32>(((_e896 - _e907) * 16i)), bitcast<u32>(((_e896 - _e909) * 16i)), bitcast<u32>(((_e899 - _e909) * 16i)), bitcast<u32>(((_e899 - _e911) * 16i)), bitcast<u32>(((select(_e891, _e900, (_e900 < _e891)) - _e911) * 16i))));
local_7 = vec3<f32>((_e522 - f32(_e805)), (_e533 - f32(_e820)), (_e544 - f32(_e835)));
let _e949 = (_e935 + _e931);
let _e952 = local_6.member[0u];
let _e953 = (_e949 + _e952);
let _e955 = (_e953 >> bitcast<u32>(1i));
let _e958 = bitcast<u32>(((_e953 & 1i) * 16i));
let _e960 = (bitcast<i32>(_e117) - 1i);
let _e962 = select(_e960, _e955, (_e955 < _e960));
let _e967 = global_1.member[bitcast<u32>(select(0i, _e962, (_e962 > 0i)))];
let _e971 = (_e955 + 1i);
let _e973 = select(_e960, _e971, (_e971 < _e960));
let _e978 = global_1.member[bitcast<u32>(select(0i, _e973, (_e973 > 0i)))];
let _e985 = ((_e967 >> bitcast<u32>((_e958 & 31u))) | ((_e978 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e958) & 31u))));
let _e988 = local_6.member[2u];
let _e989 = (_e949 + _e988);
let _e991 = (_e989 >> bitcast<u32>(1i));
let _e994 = bitcast<u32>(((_e989 & 1i) * 16i));
let _e996 = select(_e960, _e991, (_e991 < _e960));
let _e1001 = global_1.member[bitcast<u32>(select(0i, _e996, (_e996 > 0i)))];
let _e1005 = (_e991 + 1i);
let _e1007 = select(_e960, _e1005, (_e1005 < _e960));
let _e1012 = global_1.member[bitcast<u32>(select(0i, _e1007, (_e1007 > 0i)))];
let _e1019 = ((_e1001 >> bitcast<u32>((_e994 & 31u))) | ((_e1012 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e994) & 31u))));
let _e1022 = local_6.member_1[0u];
let _e1028 = f32(bitcast<i32>(((_e985 >> bitcast<u32>((_e1022 & 31u))) & 65535u)));
let _e1031 = local_6.member_1[1u];
let _e1037 = f32(bitcast<i32>(((_e985 >> bitcast<u32>((_e1031 & 31u))) & 65535u)));
let _e1040 = local_6.member_1[4u];
let _e1046 = f32(bitcast<i32>(((_e1019 >> bitcast<u32>((_e1040 & 31u))) & 65535u)));
let _e1049 = local_6.member_1[5u];
let _e1056 = local_7[0u];
let _e1059 = (_e1028 + ((_e1037 - _e1028) * _e1056));
let _e1060 = local_7[0u];
let _e1063 = (_e1037 + ((_e1046 - _e1037) * _e1060));
let _e1064 = local_7[0u];
let _e1067 = (_e1046 + ((f32(bitcast<i32>(((_e1019 >> bitcast<u32>((_e1049 & 31u))) & 65535u))) - _e1046) * _e1064));
let _e1068 = (_e935 + _e932);
let _e1069 = local_6.member[0u];
let _e1070 = (_e1068 + _e1069);
let _e1072 = (_e1070 >> bitcast<u32>(1i));
let _e1075 = bitcast<u32>(((_e1070 & 1i) * 16i));
let _e1077 = select(_e960, _e1072, (_e1072 < _e960));
let _e1082 = global_1.member[bitcast<u32>(select(0i, _e1077, (_e1077 > 0i)))];
let _e1086 = (_e1072 + 1i);
let _e1088 = select(_e960, _e1086, (_e1086 < _e960));
let _e1093 = global_1.member[bitcast<u32>(select(0i, _e1088, (_e1088 > 0i)))];
let _e1100 = ((_e1082 >> bitcast<u32>((_e1075 & 31u))) | ((_e1093 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1075) & 31u))));
let _e1101 = local_6.member[2u];
let _e1102 = (_e1068 + _e1101);
let _e1104 = (_e1102 >> bitcast<u32>(1i));
let _e1107 = bitcast<u32>(((_e1102 & 1i) * 16i));
let _e1109 = select(_e960, _e1104, (_e1104 < _e960));
let _e1114 = global_1.member[bitcast<u32>(select(0i, _e1109, (_e1109 > 0i)))];
let _e1118 = (_e1104 + 1i);
let _e1120 = select(_e960, _e1118, (_e1118 < _e960));
let _e1125 = global_1.member[bitcast<u32>(select(0i, _e1120, (_e1120 > 0i)))];
let _e1132 = ((_e1114 >> bitcast<u32>((_e1107 & 31u))) | ((_e1125 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1107) & 31u))));
let _e1133 = local_6.member_1[0u];
let _e1139 = f32(bitcast<i32>(((_e1100 >> bitcast<u32>((_e1133 & 31u))) & 65535u)));
let _e1140 = local_6.member_1[1u];
let _e1146 = f32(bitcast<i32>(((_e1100 >> bitcast<u32>((_e1140 & 31u))) & 65535u)));
let _e1147 = local_6.member_1[4u];
let _e1153 = f32(bitcast<i32>(((_e1132 >> bitcast<u32>((_e1147 & 31u))) & 65535u)));
let _e1154 = local_6.member_1[5u];
let _e1161 = local_7[0u];
let _e1165 = local_7[0u];
let _e1168 = (_e1146 + ((_e1153 - _e1146) * _e1165));
let _e1169 = local_7[0u];
let _e1173 = (_e936 + _e931);
let _e1174 = local_6.member[0u];
let _e1175 = (_e1173 + _e1174);
let _e1177 = (_e1175 >> bitcast<u32>(1i));
let _e1180 = bitcast<u32>(((_e1175 & 1i) * 16i));
let _e1182 = select(_e960, _e1177, (_e1177 < _e960));
let _e1187 = global_1.member[bitcast<u32>(select(0i, _e1182, (_e1182 > 0i)))];
let _e1191 = (_e1177 + 1i);
let _e1193 = select(_e960, _e1191, (_e1191 < _e960));
let _e1198 = global_1.member[bitcast<u32>(select(0i, _e1193, (_e1193 > 0i)))];
let _e1205 = ((_e1187 >> bitcast<u32>((_e1180 & 31u))) | ((_e1198 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1180) & 31u))));
let _e1206 = local_6.member[2u];
let _e1207 = (_e1173 + _e1206);
let _e1209 = (_e1207 >> bitcast<u32>(1i));
let _e1212 = bitcast<u32>(((_e1207 & 1i) * 16i));
let _e1214 = select(_e960, _e1209, (_e1209 < _e960));
let _e1219 = global_1.member[bitcast<u32>(select(0i, _e1214, (_e1214 > 0i)))];
let _e1223 = (_e1209 + 1i);
let _e1225 = select(_e960, _e1223, (_e1223 < _e960));
let _e1230 = global_1.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1237 = ((_e1219 >> bitcast<u32>((_e1212 & 31u))) | ((_e1230 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1212) & 31u))));
let _e1238 = local_6.member_1[0u];
let _e1244 = f32(bitcast<i32>(((_e1205 >> bitcast<u32>((_e1238 & 31u))) & 65535u)));
let _e1245 = local_6.member_1[1u];
let _e1251 = f32(bitcast<i32>(((_e1205 >> bitcast<u32>((_e1245 & 31u))) & 65535u)));
let _e1252 = local_6.member_1[4u];
let _e1258 = f32(bitcast<i32>(((_e1237 >> bitcast<u32>((_e1252 & 31u))) & 65535u)));
let _e1259 = local_6.member_1[5u];
let _e1266 = local_7[0u];
let _e1269 = (_e1244 + ((_e1251 - _e1244) * _e1266));
let _e1270 = local_7[0u];
let _e1273 = (_e1251 + ((_e1258 - _e1251) * _e1270));
let _e1274 = local_7[0u];
let _e1277 = (_e1258 + ((f32(bitcast<i32>(((_e1237 >> bitcast<u32>((_e1259 & 31u))) & 65535u))) - _e1258) * _e1274));
let _e1278 = (_e936 + _e932);
let _e1279 = local_6.member[0u];
let _e1280 = (_e1278 + _e1279);
let _e1282 = (_e1280 >> bitcast<u32>(1i));
let _e1285 = bitcast<u32>(((_e1280 & 1i) * 16i));
let _e1287 = select(_e960, _e1282, (_e1282 < _e960));
let _e1292 = global_1.member[bitcast<u32>(select(0i, _e1287, (_e1287 > 0i)))];
let _e1296 = (_e1282 + 1i);
let _e1298 = select(_e960, _e1296, (_e1296 < _e960));
let _e1303 = global_1.member[bitcast<u32>(select(0i, _e1298, (_e1298 > 0i)))];
let _e1310 = ((_e1292 >> bitcast<u32>((_e1285 & 31u))) | ((_e1303 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1285) & 31u))));
let _e1311 = local_6.member[2u];
let _e1312 = (_e1278 + _e1311);
let _e1314 = (_e1312 >> bitcast<u32>(1i));
let _e1317 = bitcast<u32>(((_e1312 & 1i) * 16i));
let _e1319 = select(_e960, _e1314, (_e1314 < _e960));
let _e1324 = global_1.member[bitcast<u32>(select(0i, _e1319, (_e1319 > 0i)))];
let _e1328 = (_e1314 + 1i);
let _e1330 = select(_e960, _e1328, (_e1328 < _e960));
let _e1335 = global_1.member[bitcast<u32>(select(0i, _e1330, (_e1330 > 0i)))];
let _e1342 = ((_e1324 >> bitcast<u32>((_e1317 & 31u))) | ((_e1335 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1317) & 31u))));
let _e1343 = local_6.member_1[0u];
let _e1349 = f32(bitcast<i32>(((_e1310 >> bitcast<u32>((_e1343 & 31u))) & 65535u)));
let _e1350 = local_6.member_1[1u];
let _e1356 = f32(bitcast<i32>(((_e1310 >> bitcast<u32>((_e1350 & 31u))) & 65535u)));
let _e1357 = local_6.member_1[4u];
let _e1363 = f32(bitcast<i32>(((_e1342 >> bitcast<u32>((_e1357 & 31u))) & 65535u)));
let _e1364 = local_6.member_1[5u];
let _e1371 = local_7[0u];
let _e1375 = local_7[0u];
let _e1378 = (_e1356 + ((_e1363 - _e1356) * _e1375));
let _e1379 = local_7[0u];
let _e1386 = local_6.member[1u];
let _e1387 = ((_e935 + _e930) + _e1386);
let _e1389 = (_e1387 >> bitcast<u32>(1i));
let _e1392 = bitcast<u32>(((_e1387 & 1i) * 16i));
let _e1394 = select(_e960, _e1389, (_e1389 < _e960));
let _e1399 = global_1.member[bitcast<u32>(select(0i, _e1394, (_e1394 > 0i)))];
let _e1403 = (_e1389 + 1i);
let _e1405 = select(_e960, _e1403, (_e1403 < _e960));
let _e1410 = global_1.member[bitcast<u32>(select(0i, _e1405, (_e1405 > 0i)))];
let _e1417 = ((_e1399 >> bitcast<u32>((_e1392 & 31u))) | ((_e1410 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1392) & 31u))));
let _e1420 = local_6.member_1[2u];
let _e1426 = f32(bitcast<i32>(((_e1417 >> bitcast<u32>((_e1420 & 31u))) & 65535u)));
let _e1429 = local_6.member_1[3u];
let _e1436 = local_7[0u];
let _e1439 = (_e1426 + ((f32(bitcast<i32>(((_e1417 >> bitcast<u32>((_e1429 & 31u))) & 65535u))) - _e1426) * _e1436));
let _e1441 = local_6.member[1u];
let _e1442 = ((_e935 + _e933) + _e1441);
let _e1444 = (_e1442 >> bitcast<u32>(1i));
let _e1447 = bitcast<u32>(((_e1442 & 1i) * 16i));
let _e1449 = select(_e960, _e1444, (_e1444 < _e960));
let _e1454 = global_1.member[bitcast<u32>(select(0i, _e1449, (_e1449 > 0i)))];
let _e1458 = (_e1444 + 1i);
let _e1460 = select(_e960, _e1458, (_e1458 < _e960));
let _e1465 = global_1.member[bitcast<u32>(select(0i, _e1460, (_e1460 > 0i)))];
let _e1472 = ((_e1454 >> bitcast<u32>((_e1447 & 31u))) | ((_e1465 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1447) & 31u))));
let _e1473 = local_6.member_1[2u];
let _e1479 = f32(bitcast<i32>(((_e1472 >> bitcast<u32>((_e1473 & 31u))) & 65535u)));
let _e1480 = local_6.member_1[3u];
let _e1487 = local_7[0u];
let _e1492 = local_6.member[1u];
let _e1493 = ((_e936 + _e930) + _e1492);
let _e1495 = (_e1493 >> bitcast<u32>(1i));
let _e1498 = bitcast<u32>(((_e1493 & 1i) * 16i));
let _e1500 = select(_e960, _e1495, (_e1495 < _e960));
let _e1505 = global_1.member[bitcast<u32>(select(0i, _e1500, (_e1500 > 0i)))];
let _e1509 = (_e1495 + 1i);
let _e1511 = select(_e960, _e1509, (_e1509 < _e960));
let _e1516 = global_1.member[bitcast<u32>(select(0i, _e1511, (_e1511 > 0i)))];
let _e1523 = ((_e1505 >> bitcast<u32>((_e1498 & 31u))) | ((_e1516 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1498) & 31u))));
let _e1524 = local_6.member_1[2u];
let _e1530 = f32(bitcast<i32>(((_e1523 >> bitcast<u32>((_e1524 & 31u))) & 65535u)));
let _e1531 = local_6.member_1[3u];
let _e1538 = local_7[0u];
let _e1541 = (_e1530 + ((f32(bitcast<i32>(((_e1523 >> bitcast<u32>((_e1531 & 31u))) & 65535u))) - _e1530) * _e1538));
let _e1543 = local_6.member[1u];
let _e1544 = ((_e936 + _e933) + _e1543);
let _e1546 = (_e1544 >> bitcast<u32>(1i));
let _e1549 = bitcast<u32>(((_e1544 & 1i) * 16i));
let _e1551 = select(_e960, _e1546, (_e1546 < _e960));
let _e1556 = global_1.member[bitcast<u32>(select(0i, _e1551, (_e1551 > 0i)))];
let _e1560 = (_e1546 + 1i);
let _e1562 = select(_e960, _e1560, (_e1560 < _e960));
let _e1567 = global_1.member[bitcast<u32>(select(0i, _e1562, (_e1562 > 0i)))];
let _e1574 = ((_e1556 >> bitcast<u32>((_e1549 & 31u))) | ((_e1567 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1549) & 31u))));
let _e1575 = local_6.member_1[2u];
let _e1581 = f32(bitcast<i32>(((_e1574 >> bitcast<u32>((_e1575 & 31u))) & 65535u)));
let _e1582 = local_6.member_1[3u];
let _e1589 = local_7[0u];
let _e1594 = local_6.member[1u];
let _e1595 = ((_e934 + _e931) + _e1594);
let _e1597 = (_e1595 >> bitcast<u32>(1i));
let _e1600 = bitcast<u32>(((_e1595 & 1i) * 16i));
let _e1602 = select(_e960, _e1597, (_e1597 < _e960));
let _e1607 = global_1.member[bitcast<u32>(select(0i, _e1602, (_e1602 > 0i)))];
let _e1611 = (_e1597 + 1i);
let _e1613 = select(_e960, _e1611, (_e1611 < _e960));
let _e1618 = global_1.member[bitcast<u32>(select(0i, _e1613, (_e1613 > 0i)))];
let _e1625 = ((_e1607 >> bitcast<u32>((_e1600 & 31u))) | ((_e1618 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1600) & 31u))));
let _e1626 = local_6.member_1[2u];
let _e1632 = f32(bitcast<i32>(((_e1625 >> bitcast<u32>((_e1626 & 31u))) & 65535u)));
let _e1633 = local_6.member_1[3u];
let _e1640 = local_7[0u];
let _e1643 = (_e1632 + ((f32(bitcast<i32>(((_e1625 >> bitcast<u32>((_e1633 & 31u))) & 65535u))) - _e1632) * _e1640));
let _e1645 = local_6.member[1u];
let _e1646 = ((_e937 + _e931) + _e1645);
let _e1648 = (_e1646 >> bitcast<u32>(1i));
let _e1651 = bitcast<u32>(((_e1646 & 1i) * 16i));
let _e1653 = select(_e960, _e1648, (_e1648 < _e960));
let _e1658 = global_1.member[bitcast<u32>(select(0i, _e1653, (_e1653 > 0i)))];
let _e1662 = (_e1648 + 1i);
let _e1664 = select(_e960, _e1662, (_e1662 < _e960));
let _e1669 = global_1.member[bitcast<u32>(select(0i, _e1664, (_e1664 > 0i)))];
let _e1676 = ((_e1658 >> bitcast<u32>((_e1651 & 31u))) | ((_e1669 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1651) & 31u))));
let _e1677 = local_6.member_1[2u];
let _e1683 = f32(bitcast<i32>(((_e1676 >> bitcast<u32>((_e1677 & 31u))) & 65535u)));
let _e1684 = local_6.member_1[3u];
let _e1691 = local_7[0u];
let _e1694 = (_e1683 + ((f32(bitcast<i32>(((_e1676 >> bitcast<u32>((_e1684 & 31u))) & 65535u))) - _e1683) * _e1691));
let _e1696 = local_6.member[1u];
let _e1697 = ((_e934 + _e932) + _e1696);
let _e1699 = (_e1697 >> bitcast<u32>(1i));
let _e1702 = bitcast<u32>(((_e1697 & 1i) * 16i));
let _e1704 = select(_e960, _e1699, (_e1699 < _e960));
let _e1709 = global_1.member[bitcast<u32>(select(0i, _e1704, (_e1704 > 0i)))];
let _e1713 = (_e1699 + 1i);
let _e1715 = select(_e960, _e1713, (_e1713 < _e960));
let _e1720 = global_1.member[bitcast<u32>(select(0i, _e1715, (_e1715 > 0i)))];
let _e1727 = ((_e1709 >> bitcast<u32>((_e1702 & 31u))) | ((_e1720 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1702) & 31u))));
let _e1728 = local_6.member_1[2u];
let _e1734 = f32(bitcast<i32>(((_e1727 >> bitcast<u32>((_e1728 & 31u))) & 65535u)));
let _e1735 = local_6.member_1[3u];
let _e1742 = local_7[0u];
let _e1747 = local_6.member[1u];
let _e1748 = ((_e937 + _e932) + _e1747);
let _e1750 = (_e1748 >> bitcast<u32>(1i));
let _e1753 = bitcast<u32>(((_e1748 & 1i) * 16i));
let _e1755 = select(_e960, _e1750, (_e1750 < _e960));
let _e1760 = global_1.member[bitcast<u32>(select(0i, _e1755, (_e1755 > 0i)))];
let _e1764 = (_e1750 + 1i);
let _e1766 = select(_e960, _e1764, (_e1764 < _e960));
let _e1771 = global_1.member[bitcast<u32>(select(0i, _e1766, (_e1766 > 0i)))];
let _e1778 = ((_e1760 >> bitcast<u32>((_e1753 & 31u))) | ((_e1771 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1753) & 31u))));
let _e1779 = local_6.member_1[2u];
let _e1785 = f32(bitcast<i32>(((_e1778 >> bitcast<u32>((_e1779 & 31u))) & 65535u)));
let _e1786 = local_6.member_1[3u];
let _e1793 = local_7[0u];
let _e1798 = local_7[1u];
let _e1801 = (_e1063 + ((_e1168 - _e1063) * _e1798));
let _e1802 = local_7[1u];
let _e1805 = (_e1273 + ((_e1378 - _e1273) * _e1802));
let _e1806 = local_7[1u];
let _e1809 = (_e1059 + (((_e1139 + ((_e1146 - _e1139) * _e1161)) - _e1059) * _e1806));
let _e1810 = local_7[1u];
let _e1815 = local_7[2u];
let _e1819 = local_7[1u];
let _e1822 = (_e1067 + (((_e1153 + ((f32(bitcast<i32>(((_e1132 >> bitcast<u32>((_e1154 & 31u))) & 65535u))) - _e1153) * _e1169)) - _e1067) * _e1819));
let _e1823 = local_7[1u];
let _e1827 = local_7[2u];
let _e1831 = local_7[1u];
let _e1834 = (_e1439 + ((_e1063 - _e1439) * _e1831));
let _e1835 = local_7[1u];
let _e1839 = local_7[2u];
let _e1843 = local_7[1u];
let _e1846 = (_e1168 + (((_e1479 + ((f32(bitcast<i32>(((_e1472 >> bitcast<u32>((_e1480 & 31u))) & 65535u))) - _e1479) * _e1487)) - _e1168) * _e1843));
let _e1847 = local_7[1u];
let _e1851 = local_7[2u];
let _e1855 = local_7[1u];
let _e1858 = (_e1643 + (((_e1734 + ((f32(bitcast<i32>(((_e1727 >> bitcast<u32>((_e1735 & 31u))) & 65535u))) - _e1734) * _e1742)) - _e1643) * _e1855));
let _e1859 = local_7[2u];
let _e1863 = local_7[1u];
let _e1867 = local_7[2u];
let _e1871 = local_7[2u];
let _e1879 = global_5.member[_e350].member_6.member_5;
let _e1885 = global_5.member[_e350].member_6.member_6;
let _e1886 = (((_e1801 + ((_e1805 - _e1801) * _e1871)) * _e1879) + _e1885);
let _e1888 = select(0f, _e1886, (_e1886 > 0f));
let _e1890 = select(1f, _e1888, (_e1888 < 1f));
let _e1892 = (((_e1809 + (((_e1269 + (((_e1349 + ((_e1356 - _e1349) * _e1371)) - _e1269) * _e1810)) - _e1809) * _e1815)) * _e1879) + _e1885);
let _e1894 = select(0f, _e1892, (_e1892 > 0f));
let _e1896 = select(1f, _e1894, (_e1894 < 1f));
let _e1898 = (((_e1822 + (((_e1277 + (((_e1363 + ((f32(bitcast<i32>(((_e1342 >> bitcast<u32>((_e1364 & 31u))) & 65535u))) - _e1363) * _e1379)) - _e1277) * _e1823)) - _e1822) * _e1827)) * _e1879) + _e1885);
let _e1900 = select(0f, _e1898, (_e1898 > 0f));
let _e1902 = select(1f, _e1900, (_e1900 < 1f));
let _e1904 = (((_e1834 + (((_e1541 + ((_e1273 - _e1541) * _e1835)) - _e1834) * _e1839)) * _e1879) + _e1885);
let _e1906 = select(0f, _e1904, (_e1904 > 0f));
let _e1908 = select(1f, _e1906, (_e1906 < 1f));
let _e1910 = (((_e1846 + (((_e1378 + (((_e1581 + ((f32(bitcast<i32>(((_e1574 >> bitcast<u32>((_e1582 & 31u))) & 65535u))) - _e1581) * _e1589)) - _e1378) * _e1847)) - _e1846) * _e1851)) * _e1879) + _e1885);
let _e1912 = select(0f, _e1910, (_e1910 > 0f));
let _e1914 = select(1f, _e1912, (_e1912 < 1f));
let _e1916 = (((_e1858 + ((_e1801 - _e1858) * _e1859)) * _e1879) + _e1885);
let _e1918 = select(0f, _e1916, (_e1916 > 0f));
let _e1920 = select(1f, _e1918, (_e1918 < 1f));
let _e1922 = (((_e1805 + (((_e1694 + (((_e1785 + ((f32(bitcast<i32>(((_e1778 >> bitcast<u32>((_e1786 & 31u))) & 65535u))) - _e1785) * _e1793)) - _e1694) * _e1863)) - _e1805) * _e1867)) * _e1879) + _e1885);
let _e1924 = select(0f, _e1922, (_e1922 > 0f));
let _e1926 = select(1f, _e1924, (_e1924 < 1f));
let _e1927 = (_e1890 * 1024f);
let _e1928 = (1024f - 1f);
let _e1930 = select(0f, _e1927, (_e1927 > 0f));
let _e1932 = select(_e1928, _e1930, (_e1930 < _e1928));
let _e1939 = select(0i, select(select(i32(_e1932), i32(-2147483648), (_e1932 < -2147483600f)), 2147483647i, (_e1932 > 2147483500f)), (_e1932 == _e1932));
let _e1943 = (_e1939 - select(0i, 1i, (_e1932 < f32(_e1939))));
let _e1944 = (262147i + _e1943);
let _e1946 = (bitcast<i32>(_e121) - 1i);
let _e1948 = select(_e1946, _e1944, (_e1944 < _e1946));
let _e1954 = global_3.member[bitcast<u32>(select(0i, _e1948, (_e1948 > 0i)))];
let _e1964 = select(_e1946, 262146i, (262146i < _e1946));
let _e1970 = global_3.member[bitcast<u32>(select(0i, _e1964, (_e1964 > 0i)))];
let _e1971 = bitcast<f32>(_e1970);
let _e1972 = (f32((bitcast<i32>((_e1954 & 4095u)) - 2048i)) * _e1971);
let _e1974 = select(_e1946, 262144i, (262144i < _e1946));
let _e1980 = global_3.member[bitcast<u32>(select(0i, _e1974, (_e1974 > 0i)))];
let _e1981 = bitcast<f32>(_e1980);
let _e1983 = select(_e1946, 262145i, (262145i < _e1946));
let _e1989 = global_3.member[bitcast<u32>(select(0i, _e1983, (_e1983 > 0i)))];
let _e1990 = bitcast<f32>(_e1989);
let _e1996 = ((_e1981 + (f32(bitcast<i32>((_e1954 >> bitcast<u32>(12u)))) * _e1990)) + (_e1972 * (_e1927 - f32(_e1943))));
let _e1997 = (_e1972 * 1024f);
if _e787 {
let _e2004 = ((0.5f * (_e1902 - _e1896)) * _e1997);
let _e2005 = ((0.5f * (_e1914 - _e1908)) * _e1997);
let _e2006 = ((0.5f * (_e1926 - _e1920)) * _e1997);
phi_3878_ = type_29(_e1996, vec3<f32>(_e2004, _e2005, _e2006), vec3<f32>((_e2004 * _e1996), (_e2005 * _e1996), (_e2006 * _e1996)));
} else {
let _e2013 = (_e1896 * 1024f);
let _e2015 = select(0f, _e2013, (_e2013 > 0f));
let _e2017 = select(_e1928, _e2015, (_e2015 < _e1928));
let _e2024 = select(0i, select(select(i32(_e2017), i32(-2147483648), (_e2017 < -2147483600f)), 2147483647i, (_e2017 > 2147483500f)), (_e2017 == _e2017));
let _e2028 = (_e2024 - select(0i, 1i, (_e2017 < f32(_e2024))));
let _e2029 = (262147i + _e2028);
let _e2031 = select(_e1946, _e2029, (_e2029 < _e1946));
let _e2037 = global_3.member[bitcast<u32>(select(0i, _e2031, (_e2031 > 0i)))];
let _e2052 = ((_e1981 + (f32(bitcast<i32>((_e2037 >> bitcast<u32>(12u)))) * _e1990)) + ((f32((bitcast<i32>((_e2037 & 4095u)) - 2048i)) * _e1971) * (_e2013 - f32(_e2028))));
let _e2053 = (_e1902 * 1024f);
let _e2055 = select(0f, _e2053, (_e2053 > 0f));
let _e2057 = select(_e1928, _e2055, (_e2055 < _e1928));
let _e2064 = select(0i, select(select(i32(_e2057), i32(-2147483648), (_e2057 < -2147483600f)), 2147483647i, (_e2057 > 2147483500f)), (_e2057 == _e2057));
let _e2068 = (_e2064 - select(0i, 1i, (_e2057 < f32(_e2064))));
let _e2069 = (262147i + _e2068);
let _e2071 = select(_e1946, _e2069, (_e2069 < _e1946));
let _e2077 = global_3.member[bitcast<u32>(select(0i, _e2071, (_e2071 > 0i)))];
let _e2092 = ((_e1981 + (f32(bitcast<i32>((_e2077 >> bitcast<u32>(12u)))) * _e1990)) + ((f32((bitcast<i32>((_e2077 & 4095u)) - 2048i)) * _e1971) * (_e2053 - f32(_e2068))));
let _e2093 = (_e1908 * 1024f);
let _e2095 = select(0f, _e2093, (_e2093 > 0f));
let _e2097 = select(_e1928, _e2095, (_e2095 < _e1928));
let _e2104 = select(0i, select(select(i32(_e2097), i32(-2147483648), (_e2097 < -2147483600f)), 2147483647i, (_e2097 > 2147483500f)), (_e2097 == _e2097));
let _e2108 = (_e2104 - select(0i, 1i, (_e2097 < f32(_e2104))));
let _e2109 = (262147i + _e2108);
let _e2111 = select(_e1946, _e2109, (_e2109 < _e1946));
let _e2117 = global_3.member[bitcast<u32>(select(0i, _e2111, (_e2111 > 0i)))];
let _e2132 = ((_e1981 + (f32(bitcast<i32>((_e2117 >> bitcast<u32>(12u)))) * _e1990)) + ((f32((bitcast<i32>((_e2117 & 4095u)) - 2048i)) * _e1971) * (_e2093 - f32(_e2108))));
let _e2133 = (_e1914 * 1024f);
let _e2135 = select(0f, _e2133, (_e2133 > 0f));
let _e2137 = select(_e1928, _e2135, (_e2135 < _e1928));
let _e2144 = select(0i, select(select(i32(_e2137), i32(-2147483648), (_e2137 < -2147483600f)), 2147483647i, (_e2137 > 2147483500f)), (_e2137 == _e2137));
let _e2148 = (_e2144 - select(0i, 1i, (_e2137 < f32(_e2144))));
let _e2149 = (262147i + _e2148);
let _e2151 = select(_e1946, _e2149, (_e2149 < _e1946));
let _e2157 = global_3.member[bitcast<u32>(select(0i, _e2151, (_e2151 > 0i)))];
let _e2172 = ((_e1981 + (f32(bitcast<i32>((_e2157 >> bitcast<u32>(12u)))) * _e1990)) + ((f32((bitcast<i32>((_e2157 & 4095u)) - 2048i)) * _e1971) * (_e2133 - f32(_e2148))));
let _e2173 = (_e1920 * 1024f);
let _e2175 = select(0f, _e2173, (_e2173 > 0f));
let _e2177 = select(_e1928, _e2175, (_e2175 < _e1928));
let _e2184 = select(0i, select(select(i32(_e2177), i32(-2147483648), (_e2177 < -2147483600f)), 2147483647i, (_e2177 > 2147483500f)), (_e2177 == _e2177));
let _e2188 = (_e2184 - select(0i, 1i, (_e2177 < f32(_e2184))));
let _e2189 = (262147i + _e2188);
let _e2191 = select(_e1946, _e2189, (_e2189 < _e1946));
let _e2197 = global_3.member[bitcast<u32>(select(0i, _e2191, (_e2191 > 0i)))];
let _e2212 = ((_e1981 + (f32(bitcast<i32>((_e2197 >> bitcast<u32>(12u)))) * _e1990)) + ((f32((bitcast<i32>((_e2197 & 4095u)) - 2048i)) * _e1971) * (_e2173 - f32(_e2188))));
let _e2213 = (_e1926 * 1024f);
let _e2215 = select(0f, _e2213, (_e2213 > 0f));
let _e2217 = select(_e1928, _e2215, (_e2215 < _e1928));
let _e2224 = select(0i, select(select(i32(_e2217), i32(-2147483648), (_e2217 < -2147483600f)), 2147483647i, (_e2217 > 2147483500f)), (_e2217 == _e2217));
let _e2228 = (_e2224 - select(0i, 1i, (_e2217 < f32(_e2224))));
let _e2229 = (262147i + _e2228);
let _e2231 = select(_e1946, _e2229, (_e2229 < _e1946));
let _e2237 = global_3.member[bitcast<u32>(select(0i, _e2231, (_e2231 > 0i)))];
let _e2252 = ((_e1981 + (f32(bitcast<i32>((_e2237 >> bitcast<u32>(12u)))) * _e1990)) + ((f32((bitcast<i32>((_e2237 & 4095u)) - 2048i)) * _e1971) * (_e2213 - f32(_e2228))));
let _e2253 = (_e2092 - _e2052);
let _e2255 = (_e2172 - _e2132);
let _e2257 = (_e2252 - _e2212);
phi_3878_ = type_29(_e1996, vec3<f32>((0.5f * _e2253), (0.5f * _e2255), (0.5f * _e2257)), vec3<f32>((0.25f * (_e2253 * (_e2092 + _e2052))), (0.25f * (_e2255 * (_e2172 + _e2132))), (0.25f * (_e2257 * (_e2252 + _e2212)))));
}
let _e2272 = phi_3878_;
let _e2287 = select(0f, 1f, ((((((_e494 >= -0.5f) && (_e494 <= _e518)) && (_e500 >= -0.5f)) && (_e500 <= _e529)) && (_e506 >= -0.5f)) && (_e506 <= _e540)));
let _e2289 = (0.5f * (_e1902 - _e1896));
let _e2291 = (0.5f * (_e1914 - _e1908));
let _e2293 = (0.5f * (_e1926 - _e1920));
let _e2300 = global_5.member[_e350].member_6.member.member.member;
let _e2307 = global_5.member[_e350].member_6.member.member.member_1;
let _e2314 = global_5.member[_e350].member_6.member.member.member_2;
let _e2321 = global_5.member[_e350].member_6.member_1.member.member;
let _e2328 = global_5.member[_e350].member_6.member_1.member.member_1;
let _e2335 = global_5.member[_e350].member_6.member_1.member.member_2;
let _e2342 = global_5.member[_e350].member_6.member_2.member.member;
let _e2349 = global_5.member[_e350].member_6.member_2.member.member_1;
let _e2356 = global_5.member[_e350].member_6.member_2.member.member_2;
phi_4656_ = type_30(_e1890, vec3<f32>(((((_e2300 * _e2289) + (_e2321 * _e2291)) + (_e2342 * _e2293)) * _e2287), ((((_e2307 * _e2289) + (_e2328 * _e2291)) + (_e2349 * _e2293)) * _e2287), ((((_e2314 * _e2289) + (_e2335 * _e2291)) + (_e2356 * _e2293)) * _e2287)), _e2272.member, vec3<f32>(((((_e2300 * _e2272.member_2.x) + (_e2321 * _e2272.member_2.y)) + (_e2342 * _e2272.member_2.z)) * _e2287), ((((_e2307 * _e2272.member_2.x) + (_e2328 * _e2272.member_2.y)) + (_e2349 * _e2272.member_2.z)) * _e2287), ((((_e2314 * _e2272.member_2.x) + (_e2335 * _e2272.member_2.y)) + (_e2356 * _e2272.member_2.z)) * _e2287)), vec3<f32>(((((_e2300 * _e2272.member_1.x) + (_e2321 * _e2272.member_1.y)) + (_e2342 * _e2272.member_1.z)) * _e2287), ((((_e2307 * _e2272.member_1.x) + (_e2328 * _e2272.member_1.y)) + (_e2349 * _e2272.member_1.z)) * _e2287), ((((_e2314 * _e2272.member_1.x) + (_e2335 * _e2272.member_1.y)) + (_e2356 * _e2272.member_1.z)) * _e2287)));
} else {
let _e2422 = select(-1f, _e522, (_e522 > -1f));
let _e2424 = select(_e517, _e2422, (_e2422 < _e517));
let _e2431 = select(0i, select(select(i32(_e2424), i32(-2147483648), (_e2424 < -2147483600f)), 2147483647i, (_e2424 > 2147483500f)), (_e2424 == _e2424));
let _e2435 = (_e2431 - select(0i, 1i, (_e2424 < f32(_e2431))));
let _e2437 = select(-1f, _e533, (_e533 > -1f));
let _e2439 = select(_e528, _e2437, (_e2437 < _e528));
let _e2446 = select(0i, select(select(i32(_e2439), i32(-2147483648), (_e2439 < -2147483600f)), 2147483647i, (_e2439 > 2147483500f)), (_e2439 == _e2439));
let _e2450 = (_e2446 - select(0i, 1i, (_e2439 < f32(_e2446))));
let _e2452 = select(-1f, _e544, (_e544 > -1f));
let _e2454 = select(_e539, _e2452, (_e2452 < _e539));
let _e2461 = select(0i, select(select(i32(_e2454), i32(-2147483648), (_e2454 < -2147483600f)), 2147483647i, (_e2454 > 2147483500f)), (_e2454 == _e2454));
let _e2465 = (_e2461 - select(0i, 1i, (_e2454 < f32(_e2461))));
let _e2470 = global_5.member[_e350].member_6.member_7;
let _e2475 = global_5.member[_e350].member_6.member_8;
let _e2483 = (select(0i, select(select(i32(_e528), i32(-2147483648), (_e528 < -2147483600f)), 2147483647i, (_e528 > 2147483500f)), (_e528 == _e528)) - 1i);
let _e2486 = (_e2450 + 1i);
let _e2496 = (select(0i, select(select(i32(_e539), i32(-2147483648), (_e539 < -2147483600f)), 2147483647i, (_e539 > 2147483500f)), (_e539 == _e539)) - 1i);
let _e2499 = (_e2465 + 1i);
let _e2508 = select(0i, select(select(i32(_e517), i32(-2147483648), (_e517 < -2147483600f)), 2147483647i, (_e517 > 2147483500f)), (_e517 == _e517));
let _e2509 = (_e2508 - 1i);
let _e2510 = (_e2435 - 1i);
let _e2512 = select(0i, _e2510, (_e2510 > 0i));
let _e2514 = select(0i, _e2435, (_e2435 > 0i));
let _e2515 = (_e2435 + 1i);
let _e2517 = select(_e2509, _e2515, (_e2515 < _e2509));
let _e2518 = (_e2435 + 2i);
let _e2521 = (_e2508 - 2i);
let _e2523 = select(0i, _e2521, (_e2521 > 0i));
let _e2525 = select(_e2523, _e2512, (_e2512 < _e2523));
let _e2527 = select(_e2523, _e2514, (_e2514 < _e2523));
let _e2529 = select(_e2523, _e2517, (_e2517 < _e2523));
let _e2548 = (select(0i, _e2450, (_e2450 > 0i)) * _e2470);
let _e2549 = (select(_e2483, _e2486, (_e2486 < _e2483)) * _e2470);
let _e2550 = (select(0i, _e2465, (_e2465 > 0i)) * _e2475);
let _e2551 = (select(_e2496, _e2499, (_e2499 < _e2496)) * _e2475);
local_4 = type_28(array<i32, 4>(_e2525, _e2527, _e2529, 0i), array<u32, 6>(bitcast<u32>(((_e2512 - _e2525) * 16i)), bitcast<u32>(((_e2514 - _e2525) * 16i)), bitcast<u32>(((_e2514 - _e2527) * 16i)), bitcast<u32>(((_e2517 - _e2527) * 16i)), bitcast<u32>(((_e2517 - _e2529) * 16i)), bitcast<u32>(((select(_e2509, _e2518, (_e2518 < _e2509)) - _e2529) * 16i))));
local_5 = vec3<f32>((_e522 - f32(_e2435)), (_e533 - f32(_e2450)), (_e544 - f32(_e2465)));
let _e2566 = local_4.member[1u];
let _e2567 = ((_e2550 + _e2548) + _e2566);
let _e2569 = (_e2567 >> bitcast<u32>(1i));
let _e2572 = bitcast<u32>(((_e2567 & 1i) * 16i));
let _e2574 = (bitcast<i32>(_e117) - 1i);
let _e2576 = select(_e2574, _e2569, (_e2569 < _e2574));
let _e2581 = global_1.member[bitcast<u32>(select(0i, _e2576, (_e2576 > 0i)))];
let _e2585 = (_e2569 + 1i);
let _e2587 = select(_e2574, _e2585, (_e2585 < _e2574));
let _e2592 = global_1.member[bitcast<u32>(select(0i, _e2587, (_e2587 > 0i)))];
let _e2599 = ((_e2581 >> bitcast<u32>((_e2572 & 31u))) | ((_e2592 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2572) & 31u))));
let _e2602 = local_4.member_1[2u];
let _e2608 = f32(bitcast<i32>(((_e2599 >> bitcast<u32>((_e2602 & 31u))) & 65535u)));
let _e2611 = local_4.member_1[3u];
let _e2618 = local_5[0u];
let _e2621 = (_e2608 + ((f32(bitcast<i32>(((_e2599 >> bitcast<u32>((_e2611 & 31u))) & 65535u))) - _e2608) * _e2618));
let _e2623 = local_4.member[1u];
let _e2624 = ((_e2550 + _e2549) + _e2623);
let _e2626 = (_e2624 >> bitcast<u32>(1i));
let _e2629 = bitcast<u32>(((_e2624 & 1i) * 16i));
let _e2631 = select(_e2574, _e2626, (_e2626 < _e2574));
let _e2636 = global_1.member[bitcast<u32>(select(0i, _e2631, (_e2631 > 0i)))];
let _e2640 = (_e2626 + 1i);
let _e2642 = select(_e2574, _e2640, (_e2640 < _e2574));
let _e2647 = global_1.member[bitcast<u32>(select(0i, _e2642, (_e2642 > 0i)))];
let _e2654 = ((_e2636 >> bitcast<u32>((_e2629 & 31u))) | ((_e2647 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2629) & 31u))));
let _e2655 = local_4.member_1[2u];
let _e2661 = f32(bitcast<i32>(((_e2654 >> bitcast<u32>((_e2655 & 31u))) & 65535u)));
let _e2662 = local_4.member_1[3u];
let _e2669 = local_5[0u];
let _e2674 = local_5[1u];
let _e2677 = (_e2621 + (((_e2661 + ((f32(bitcast<i32>(((_e2654 >> bitcast<u32>((_e2662 & 31u))) & 65535u))) - _e2661) * _e2669)) - _e2621) * _e2674));
let _e2679 = local_4.member[1u];
let _e2680 = ((_e2551 + _e2548) + _e2679);
let _e2682 = (_e2680 >> bitcast<u32>(1i));
let _e2685 = bitcast<u32>(((_e2680 & 1i) * 16i));
let _e2687 = select(_e2574, _e2682, (_e2682 < _e2574));
let _e2692 = global_1.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2696 = (_e2682 + 1i);
let _e2698 = select(_e2574, _e2696, (_e2696 < _e2574));
let _e2703 = global_1.member[bitcast<u32>(select(0i, _e2698, (_e2698 > 0i)))];
let _e2710 = ((_e2692 >> bitcast<u32>((_e2685 & 31u))) | ((_e2703 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2685) & 31u))));
let _e2711 = local_4.member_1[2u];
let _e2717 = f32(bitcast<i32>(((_e2710 >> bitcast<u32>((_e2711 & 31u))) & 65535u)));
let _e2718 = local_4.member_1[3u];
let _e2725 = local_5[0u];
let _e2728 = (_e2717 + ((f32(bitcast<i32>(((_e2710 >> bitcast<u32>((_e2718 & 31u))) & 65535u))) - _e2717) * _e2725));
let _e2730 = local_4.member[1u];
let _e2731 = ((_e2551 + _e2549) + _e2730);
let _e2733 = (_e2731 >> bitcast<u32>(1i));
let _e2736 = bitcast<u32>(((_e2731 & 1i) * 16i));
let _e2738 = select(_e2574, _e2733, (_e2733 < _e2574));
let _e2743 = global_1.member[bitcast<u32>(select(0i, _e2738, (_e2738 > 0i)))];
let _e2747 = (_e2733 + 1i);
let _e2749 = select(_e2574, _e2747, (_e2747 < _e2574));
let _e2754 = global_1.member[bitcast<u32>(select(0i, _e2749, (_e2749 > 0i)))];
let _e2761 = ((_e2743 >> bitcast<u32>((_e2736 & 31u))) | ((_e2754 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2736) & 31u))));
let _e2762 = local_4.member_1[2u];
let _e2768 = f32(bitcast<i32>(((_e2761 >> bitcast<u32>((_e2762 & 31u))) & 65535u)));
let _e2769 = local_4.member_1[3u];
let _e2776 = local_5[0u];
let _e2780 = local_5[1u];
let _e2785 = local_5[2u];
let _e2793 = global_5.member[_e350].member_6.member_5;
let _e2799 = global_5.member[_e350].member_6.member_6;
let _e2800 = (((_e2677 + (((_e2728 + (((_e2768 + ((f32(bitcast<i32>(((_e2761 >> bitcast<u32>((_e2769 & 31u))) & 65535u))) - _e2768) * _e2776)) - _e2728) * _e2780)) - _e2677) * _e2785)) * _e2793) + _e2799);
let _e2802 = select(0f, _e2800, (_e2800 > 0f));
phi_4656_ = type_30(select(1f, _e2802, (_e2802 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2807 = phi_4656_;
let _e2811 = select(-0.5f, _e456, (_e456 > -0.5f));
let _e2813 = select(_e518, _e2811, (_e2811 < _e518));
let _e2815 = select(-0.5f, _e472, (_e472 > -0.5f));
let _e2817 = select(_e529, _e2815, (_e2815 < _e529));
let _e2819 = select(-0.5f, _e488, (_e488 > -0.5f));
let _e2821 = select(_e540, _e2819, (_e2819 < _e540));
let _e2823 = select(-1f, _e2813, (_e2813 > -1f));
let _e2825 = select(_e517, _e2823, (_e2823 < _e517));
let _e2832 = select(0i, select(select(i32(_e2825), i32(-2147483648), (_e2825 < -2147483600f)), 2147483647i, (_e2825 > 2147483500f)), (_e2825 == _e2825));
let _e2836 = (_e2832 - select(0i, 1i, (_e2825 < f32(_e2832))));
let _e2838 = select(-1f, _e2817, (_e2817 > -1f));
let _e2840 = select(_e528, _e2838, (_e2838 < _e528));
let _e2847 = select(0i, select(select(i32(_e2840), i32(-2147483648), (_e2840 < -2147483600f)), 2147483647i, (_e2840 > 2147483500f)), (_e2840 == _e2840));
let _e2851 = (_e2847 - select(0i, 1i, (_e2840 < f32(_e2847))));
let _e2853 = select(-1f, _e2821, (_e2821 > -1f));
let _e2855 = select(_e539, _e2853, (_e2853 < _e539));
let _e2862 = select(0i, select(select(i32(_e2855), i32(-2147483648), (_e2855 < -2147483600f)), 2147483647i, (_e2855 > 2147483500f)), (_e2855 == _e2855));
let _e2866 = (_e2862 - select(0i, 1i, (_e2855 < f32(_e2862))));
let _e2871 = global_5.member[_e350].member_6.member_7;
let _e2876 = global_5.member[_e350].member_6.member_8;
let _e2884 = (select(0i, select(select(i32(_e528), i32(-2147483648), (_e528 < -2147483600f)), 2147483647i, (_e528 > 2147483500f)), (_e528 == _e528)) - 1i);
let _e2887 = (_e2851 + 1i);
let _e2897 = (select(0i, select(select(i32(_e539), i32(-2147483648), (_e539 < -2147483600f)), 2147483647i, (_e539 > 2147483500f)), (_e539 == _e539)) - 1i);
let _e2900 = (_e2866 + 1i);
let _e2909 = select(0i, select(select(i32(_e517), i32(-2147483648), (_e517 < -2147483600f)), 2147483647i, (_e517 > 2147483500f)), (_e517 == _e517));
let _e2910 = (_e2909 - 1i);
let _e2911 = (_e2836 - 1i);
let _e2913 = select(0i, _e2911, (_e2911 > 0i));
let _e2915 = select(0i, _e2836, (_e2836 > 0i));
let _e2916 = (_e2836 + 1i);
let _e2918 = select(_e2910, _e2916, (_e2916 < _e2910));
let _e2919 = (_e2836 + 2i);
let _e2922 = (_e2909 - 2i);
let _e2924 = select(0i, _e2922, (_e2922 > 0i));
let _e2926 = select(_e2924, _e2913, (_e2913 < _e2924));
let _e2928 = select(_e2924, _e2915, (_e2915 < _e2924));
let _e2930 = select(_e2924, _e2918, (_e2918 < _e2924));
let _e2949 = (select(0i, _e2851, (_e2851 > 0i)) * _e2871);
let _e2950 = (select(_e2884, _e2887, (_e2887 < _e2884)) * _e2871);
let _e2951 = (select(0i, _e2866, (_e2866 > 0i)) * _e2876);
let _e2952 = (select(_e2897, _e2900, (_e2900 < _e2897)) * _e2876);
local_2 = type_28(array<i32, 4>(_e2926, _e2928, _e2930, 0i), array<u32, 6>(bitcast<u32>(((_e2913 - _e2926) * 16i)), bitcast<u32>(((_e2915 - _e2926) * 16i)), bitcast<u32>(((_e2915 - _e2928) * 16i)), bitcast<u32>(((_e2918 - _e2928) * 16i)), bitcast<u32>(((_e2918 - _e2930) * 16i)), bitcast<u32>(((select(_e2910, _e2919, (_e2919 < _e2910)) - _e2930) * 16i))));
local_3 = vec3<f32>((_e2813 - f32(_e2836)), (_e2817 - f32(_e2851)), (_e2821 - f32(_e2866)));
let _e2967 = local_2.member[1u];
let _e2968 = ((_e2951 + _e2949) + _e2967);
let _e2970 = (_e2968 >> bitcast<u32>(1i));
let _e2973 = bitcast<u32>(((_e2968 & 1i) * 16i));
let _e2975 = (bitcast<i32>(_e117) - 1i);
let _e2977 = select(_e2975, _e2970, (_e2970 < _e2975));
let _e2982 = global_1.member[bitcast<u32>(select(0i, _e2977, (_e2977 > 0i)))];
let _e2986 = (_e2970 + 1i);
let _e2988 = select(_e2975, _e2986, (_e2986 < _e2975));
let _e2993 = global_1.member[bitcast<u32>(select(0i, _e2988, (_e2988 > 0i)))];
let _e3000 = ((_e2982 >> bitcast<u32>((_e2973 & 31u))) | ((_e2993 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2973) & 31u))));
let _e3003 = local_2.member_1[2u];
let _e3009 = f32(bitcast<i32>(((_e3000 >> bitcast<u32>((_e3003 & 31u))) & 65535u)));
let _e3012 = local_2.member_1[3u];
let _e3019 = local_3[0u];
let _e3022 = (_e3009 + ((f32(bitcast<i32>(((_e3000 >> bitcast<u32>((_e3012 & 31u))) & 65535u))) - _e3009) * _e3019));
let _e3024 = local_2.member[1u];
let _e3025 = ((_e2951 + _e2950) + _e3024);
let _e3027 = (_e3025 >> bitcast<u32>(1i));
let _e3030 = bitcast<u32>(((_e3025 & 1i) * 16i));
let _e3032 = select(_e2975, _e3027, (_e3027 < _e2975));
let _e3037 = global_1.member[bitcast<u32>(select(0i, _e3032, (_e3032 > 0i)))];
let _e3041 = (_e3027 + 1i);
let _e3043 = select(_e2975, _e3041, (_e3041 < _e2975));
let _e3048 = global_1.member[bitcast<u32>(select(0i, _e3043, (_e3043 > 0i)))];
let _e3055 = ((_e3037 >> bitcast<u32>((_e3030 & 31u))) | ((_e3048 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3030) & 31u))));
let _e3056 = local_2.member_1[2u];
let _e3062 = f32(bitcast<i32>(((_e3055 >> bitcast<u32>((_e3056 & 31u))) & 65535u)));
let _e3063 = local_2.member_1[3u];
let _e3070 = local_3[0u];
let _e3075 = local_3[1u];
let _e3078 = (_e3022 + (((_e3062 + ((f32(bitcast<i32>(((_e3055 >> bitcast<u32>((_e3063 & 31u))) & 65535u))) - _e3062) * _e3070)) - _e3022) * _e3075));
let _e3080 = local_2.member[1u];
let _e3081 = ((_e2952 + _e2949) + _e3080);
let _e3083 = (_e3081 >> bitcast<u32>(1i));
let _e3086 = bitcast<u32>(((_e3081 & 1i) * 16i));
let _e3088 = select(_e2975, _e3083, (_e3083 < _e2975));
let _e3093 = global_1.member[bitcast<u32>(select(0i, _e3088, (_e3088 > 0i)))];
let _e3097 = (_e3083 + 1i);
let _e3099 = select(_e2975, _e3097, (_e3097 < _e2975));
let _e3104 = global_1.member[bitcast<u32>(select(0i, _e3099, (_e3099 > 0i)))];
let _e3111 = ((_e3093 >> bitcast<u32>((_e3086 & 31u))) | ((_e3104 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3086) & 31u))));
let _e3112 = local_2.member_1[2u];
let _e3118 = f32(bitcast<i32>(((_e3111 >> bitcast<u32>((_e3112 & 31u))) & 65535u)));
let _e3119 = local_2.member_1[3u];
let _e3126 = local_3[0u];
let _e3129 = (_e3118 + ((f32(bitcast<i32>(((_e3111 >> bitcast<u32>((_e3119 & 31u))) & 65535u))) - _e3118) * _e3126));
let _e3131 = local_2.member[1u];
let _e3132 = ((_e2952 + _e2950) + _e3131);
let _e3134 = (_e3132 >> bitcast<u32>(1i));
let _e3137 = bitcast<u32>(((_e3132 & 1i) * 16i));
let _e3139 = select(_e2975, _e3134, (_e3134 < _e2975));
let _e3144 = global_1.member[bitcast<u32>(select(0i, _e3139, (_e3139 > 0i)))];
let _e3148 = (_e3134 + 1i);
let _e3150 = select(_e2975, _e3148, (_e3148 < _e2975));
let _e3155 = global_1.member[bitcast<u32>(select(0i, _e3150, (_e3150 > 0i)))];
let _e3162 = ((_e3144 >> bitcast<u32>((_e3137 & 31u))) | ((_e3155 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3137) & 31u))));
let _e3163 = local_2.member_1[2u];
let _e3169 = f32(bitcast<i32>(((_e3162 >> bitcast<u32>((_e3163 & 31u))) & 65535u)));
let _e3170 = local_2.member_1[3u];
let _e3177 = local_3[0u];
let _e3181 = local_3[1u];
let _e3186 = local_3[2u];
let _e3194 = global_5.member[_e350].member_6.member_5;
let _e3200 = global_5.member[_e350].member_6.member_6;
let _e3201 = (((_e3078 + (((_e3129 + (((_e3169 + ((f32(bitcast<i32>(((_e3162 >> bitcast<u32>((_e3170 & 31u))) & 65535u))) - _e3169) * _e3177)) - _e3129) * _e3181)) - _e3078) * _e3186)) * _e3194) + _e3200);
let _e3203 = select(0f, _e3201, (_e3201 > 0f));
let _e3205 = select(1f, _e3203, (_e3203 < 1f));
let _e3206 = select(_e354[5], _e3205, _e716);
if _e790 {
let _e3207 = (_e3205 * 1024f);
let _e3208 = (1024f - 1f);
let _e3210 = select(0f, _e3207, (_e3207 > 0f));
let _e3212 = select(_e3208, _e3210, (_e3210 < _e3208));
let _e3219 = select(0i, select(select(i32(_e3212), i32(-2147483648), (_e3212 < -2147483600f)), 2147483647i, (_e3212 > 2147483500f)), (_e3212 == _e3212));
let _e3223 = (_e3219 - select(0i, 1i, (_e3212 < f32(_e3219))));
let _e3224 = (262147i + _e3223);
let _e3226 = (bitcast<i32>(_e121) - 1i);
let _e3228 = select(_e3226, _e3224, (_e3224 < _e3226));
let _e3234 = global_3.member[bitcast<u32>(select(0i, _e3228, (_e3228 > 0i)))];
let _e3244 = select(_e3226, 262146i, (262146i < _e3226));
let _e3250 = global_3.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3254 = select(_e3226, 262144i, (262144i < _e3226));
let _e3260 = global_3.member[bitcast<u32>(select(0i, _e3254, (_e3254 > 0i)))];
let _e3263 = select(_e3226, 262145i, (262145i < _e3226));
let _e3269 = global_3.member[bitcast<u32>(select(0i, _e3263, (_e3263 > 0i)))];
phi_5374_ = select(_e354[15], ((bitcast<f32>(_e3260) + (f32(bitcast<i32>((_e3234 >> bitcast<u32>(12u)))) * bitcast<f32>(_e3269))) + ((f32((bitcast<i32>((_e3234 & 4095u)) - 2048i)) * bitcast<f32>(_e3250)) * (_e3207 - f32(_e3223)))), _e716);
} else {
phi_5374_ = _e354[15];
}
let _e3279 = phi_5374_;
let _e3282 = select(1f, select(1f, _e785, (_e785 < 1f)), _e440);
if ((_e683 & 16u) == 0u) {
phi_5763_ = type_5(1f, 1f, 1f);
} else {
let _e3289 = global_5.member[_e350].member_14.member;
let _e3300 = ((((_e3289.member.member * _e375) + (_e3289.member.member_1 * _e378)) + (_e3289.member.member_2 * _e369)) + _e3289.member_1);
let _e3306 = ((((_e3289.member.member * _e380) + (_e3289.member.member_1 * _e382)) + (_e3289.member.member_2 * _e387)) + _e3289.member_1);
let _e3308 = select(_e3306, _e3300, (_e3300 < _e3306));
let _e3310 = select(_e3306, _e3300, (_e3300 > _e3306));
let _e3312 = (_e3310 - _e3308);
let _e3315 = (-(_e3308) / select(1e-30f, _e3312, (_e3312 > 1e-30f)));
let _e3317 = select(0f, _e3315, (_e3315 > 0f));
let _e3323 = select(select(select(1f, _e3317, (_e3317 < 1f)), 1f, (_e3310 <= 0f)), 0f, (_e3308 > 0f));
let _e3329 = global_5.member[_e350].member_14.member_1;
let _e3330 = (_e3329 != 0u);
let _e3341 = global_5.member[_e350].member_15.member;
let _e3352 = ((((_e3341.member.member * _e375) + (_e3341.member.member_1 * _e378)) + (_e3341.member.member_2 * _e369)) + _e3341.member_1);
let _e3358 = ((((_e3341.member.member * _e380) + (_e3341.member.member_1 * _e382)) + (_e3341.member.member_2 * _e387)) + _e3341.member_1);
let _e3360 = select(_e3358, _e3352, (_e3352 < _e3358));
let _e3362 = select(_e3358, _e3352, (_e3352 > _e3358));
let _e3364 = (_e3362 - _e3360);
let _e3367 = (-(_e3360) / select(1e-30f, _e3364, (_e3364 > 1e-30f)));
let _e3369 = select(0f, _e3367, (_e3367 > 0f));
let _e3375 = select(select(select(1f, _e3369, (_e3369 < 1f)), 1f, (_e3362 <= 0f)), 0f, (_e3360 > 0f));
let _e3381 = global_5.member[_e350].member_15.member_1;
let _e3382 = (_e3381 != 0u);
let _e3393 = global_5.member[_e350].member_16.member;
let _e3404 = ((((_e3393.member.member * _e375) + (_e3393.member.member_1 * _e378)) + (_e3393.member.member_2 * _e369)) + _e3393.member_1);
let _e3410 = ((((_e3393.member.member * _e380) + (_e3393.member.member_1 * _e382)) + (_e3393.member.member_2 * _e387)) + _e3393.member_1);
let _e3412 = select(_e3410, _e3404, (_e3404 < _e3410));
let _e3414 = select(_e3410, _e3404, (_e3404 > _e3410));
let _e3416 = (_e3414 - _e3412);
let _e3419 = (-(_e3412) / select(1e-30f, _e3416, (_e3416 > 1e-30f)));
let _e3421 = select(0f, _e3419, (_e3419 > 0f));
let _e3427 = select(select(select(1f, _e3421, (_e3421 < 1f)), 1f, (_e3414 <= 0f)), 0f, (_e3412 > 0f));
let _e3433 = global_5.member[_e350].member_16.member_1;
let _e3434 = (_e3433 != 0u);
let _e3445 = global_5.member[_e350].member_17.member;
let _e3456 = ((((_e3445.member.member * _e375) + (_e3445.member.member_1 * _e378)) + (_e3445.member.member_2 * _e369)) + _e3445.member_1);
let _e3462 = ((((_e3445.member.member * _e380) + (_e3445.member.member_1 * _e382)) + (_e3445.member.member_2 * _e387)) + _e3445.member_1);
let _e3464 = select(_e3462, _e3456, (_e3456 < _e3462));
let _e3466 = select(_e3462, _e3456, (_e3456 > _e3462));
let _e3468 = (_e3466 - _e3464);
let _e3471 = (-(_e3464) / select(1e-30f, _e3468, (_e3468 > 1e-30f)));
let _e3473 = select(0f, _e3471, (_e3471 > 0f));
let _e3479 = select(select(select(1f, _e3473, (_e3473 < 1f)), 1f, (_e3466 <= 0f)), 0f, (_e3464 > 0f));
let _e3485 = global_5.member[_e350].member_17.member_1;
let _e3486 = (_e3485 != 0u);
phi_5763_ = type_5(((((1f * _e3323) * _e3375) * _e3427) * _e3479), ((((1f * select(1f, _e3323, _e3330)) * select(1f, _e3375, _e3382)) * select(1f, _e3427, _e3434)) * select(1f, _e3479, _e3486)), ((((1f * select(1f, 0f, (_e3330 && (_e3306 > 0f)))) * select(1f, 0f, (_e3382 && (_e3358 > 0f)))) * select(1f, 0f, (_e3434 && (_e3410 > 0f)))) * select(1f, 0f, (_e3486 && (_e3462 > 0f)))));
}
let _e3495 = phi_5763_;
let _e3496 = (_e550 < 1e-12f);
let _e3498 = (1f / select(_e545, 1f, _e3496));
let _e3500 = ((-0.5f - _e456) * _e3498);
let _e3502 = ((_e518 - _e456) * _e3498);
let _e3508 = select(_e3502, _e3500, (_e3500 < _e3502));
let _e3510 = select(0f, _e3508, (_e3508 > 0f));
let _e3513 = select(select(1f, _e3510, (_e3510 < 1f)), select(2f, 0f, ((_e456 >= -0.5f) && (_e456 <= _e518))), _e3496);
let _e3515 = select(_e3502, _e3500, (_e3500 > _e3502));
let _e3517 = select(0f, _e3515, (_e3515 > 0f));
let _e3520 = select(select(1f, _e3517, (_e3517 < 1f)), 1f, _e3496);
let _e3521 = (_e553 < 1e-12f);
let _e3523 = (1f / select(_e546, 1f, _e3521));
let _e3525 = ((-0.5f - _e472) * _e3523);
let _e3527 = ((_e529 - _e472) * _e3523);
let _e3533 = select(_e3527, _e3525, (_e3525 < _e3527));
let _e3535 = select(0f, _e3533, (_e3533 > 0f));
let _e3538 = select(select(1f, _e3535, (_e3535 < 1f)), select(2f, 0f, ((_e472 >= -0.5f) && (_e472 <= _e529))), _e3521);
let _e3540 = select(_e3527, _e3525, (_e3525 > _e3527));
let _e3542 = select(0f, _e3540, (_e3540 > 0f));
let _e3545 = select(select(1f, _e3542, (_e3542 < 1f)), 1f, _e3521);
let _e3546 = (_e558 < 1e-12f);
let _e3548 = (1f / select(_e547, 1f, _e3546));
let _e3550 = ((-0.5f - _e488) * _e3548);
let _e3552 = ((_e540 - _e488) * _e3548);
let _e3558 = select(_e3552, _e3550, (_e3550 < _e3552));
let _e3560 = select(0f, _e3558, (_e3558 > 0f));
let _e3563 = select(select(1f, _e3560, (_e3560 < 1f)), select(2f, 0f, ((_e488 >= -0.5f) && (_e488 <= _e540))), _e3546);
let _e3565 = select(_e3552, _e3550, (_e3550 > _e3552));
let _e3567 = select(0f, _e3565, (_e3565 > 0f));
let _e3570 = select(select(1f, _e3567, (_e3567 < 1f)), 1f, _e3546);
let _e3572 = select(_e3545, _e3520, (_e3520 < _e3545));
let _e3576 = select(_e3538, _e3513, (_e3513 > _e3538));
let _e3579 = (select(_e3570, _e3572, (_e3572 < _e3570)) - select(_e3563, _e3576, (_e3576 > _e3563)));
let _e3582 = (_e380 - _e375);
let _e3583 = (_e382 - _e378);
let _e3584 = (_e387 - _e369);
let _e3589 = (((_e3582 * _e3582) + (_e3583 * _e3583)) + (_e3584 * _e3584));
let _e3599 = global_5.member[_e350].member_5.member_3;
let _e3600 = (((sqrt(select(0f, _e3589, (_e3589 > 0f))) * select(0f, _e3579, (_e3579 > 0f))) * _e3282) * _e3599);
let _e3601 = (_e727.member_2 >= 3u);
if _e3601 {
let _e3603 = (_e3206 * 255f);
let _e3604 = (_e2807.member * 255f);
let _e3605 = (255f - 1f);
let _e3607 = select(0f, _e3603, (_e3603 > 0f));
let _e3609 = select(_e3605, _e3607, (_e3607 < _e3605));
let _e3616 = select(0i, select(select(i32(_e3609), i32(-2147483648), (_e3609 < -2147483600f)), 2147483647i, (_e3609 > 2147483500f)), (_e3609 == _e3609));
let _e3620 = (_e3616 - select(0i, 1i, (_e3609 < f32(_e3616))));
let _e3622 = select(0f, _e3604, (_e3604 > 0f));
let _e3624 = select(_e3605, _e3622, (_e3622 < _e3605));
let _e3631 = select(0i, select(select(i32(_e3624), i32(-2147483648), (_e3624 < -2147483600f)), 2147483647i, (_e3624 > 2147483500f)), (_e3624 == _e3624));
let _e3635 = (_e3631 - select(0i, 1i, (_e3624 < f32(_e3631))));
let _e3638 = (((_e3620 * 256i) + _e3635) * 4i);
let _e3640 = (_e3603 - f32(_e3620));
let _e3642 = (_e3604 - f32(_e3635));
let _e3643 = (_e3638 + 2i);
let _e3645 = (bitcast<i32>(_e121) - 1i);
let _e3647 = select(_e3645, _e3643, (_e3643 < _e3645));
let _e3653 = global_3.member[bitcast<u32>(select(0i, _e3647, (_e3647 > 0i)))];
let _e3654 = (_e3638 + 6i);
let _e3656 = select(_e3645, _e3654, (_e3654 < _e3645));
let _e3662 = global_3.member[bitcast<u32>(select(0i, _e3656, (_e3656 > 0i)))];
let _e3663 = (_e3638 + 1026i);
let _e3665 = select(_e3645, _e3663, (_e3663 < _e3645));
let _e3671 = global_3.member[bitcast<u32>(select(0i, _e3665, (_e3665 > 0i)))];
let _e3672 = (_e3638 + 1030i);
let _e3674 = select(_e3645, _e3672, (_e3672 < _e3645));
let _e3680 = global_3.member[bitcast<u32>(select(0i, _e3674, (_e3674 > 0i)))];
let _e3685 = (bitcast<f32>(((_e3653 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3693 = (_e3685 + (((bitcast<f32>(((_e3662 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3685) * _e3642));
let _e3698 = (bitcast<f32>(((_e3671 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3722 = (bitcast<f32>((((_e3653 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3730 = (_e3722 + (((bitcast<f32>((((_e3662 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3722) * _e3642));
let _e3735 = (bitcast<f32>((((_e3671 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3747 = (_e3638 + 3i);
let _e3749 = select(_e3645, _e3747, (_e3747 < _e3645));
let _e3755 = global_3.member[bitcast<u32>(select(0i, _e3749, (_e3749 > 0i)))];
let _e3756 = (_e3638 + 7i);
let _e3758 = select(_e3645, _e3756, (_e3756 < _e3645));
let _e3764 = global_3.member[bitcast<u32>(select(0i, _e3758, (_e3758 > 0i)))];
let _e3765 = (_e3638 + 1027i);
let _e3767 = select(_e3645, _e3765, (_e3765 < _e3645));
let _e3773 = global_3.member[bitcast<u32>(select(0i, _e3767, (_e3767 > 0i)))];
let _e3774 = (_e3638 + 1031i);
let _e3776 = select(_e3645, _e3774, (_e3774 < _e3645));
let _e3782 = global_3.member[bitcast<u32>(select(0i, _e3776, (_e3776 > 0i)))];
let _e3787 = (bitcast<f32>(((_e3755 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3795 = (_e3787 + (((bitcast<f32>(((_e3764 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3787) * _e3642));
let _e3800 = (bitcast<f32>(((_e3773 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3824 = (bitcast<f32>((((_e3755 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3832 = (_e3824 + (((bitcast<f32>((((_e3764 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3824) * _e3642));
let _e3837 = (bitcast<f32>((((_e3773 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3848 = (_e3832 + (((_e3837 + (((bitcast<f32>((((_e3782 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3837) * _e3642)) - _e3832) * _e3640));
let _e3852 = -((_e3848 * (_e3600 * _e3495.member)));
let _e3854 = select(-87f, _e3852, (_e3852 > -87f));
let _e3856 = select(88f, _e3854, (_e3854 < 88f));
let _e3858 = ((_e3856 * 1.442695f) + 0.5f);
let _e3860 = select(-127f, _e3858, (_e3858 > -127f));
let _e3862 = select(128f, _e3860, (_e3860 < 128f));
let _e3869 = select(0i, select(select(i32(_e3862), i32(-2147483648), (_e3862 < -2147483600f)), 2147483647i, (_e3862 > 2147483500f)), (_e3862 == _e3862));
let _e3873 = (_e3869 - select(0i, 1i, (_e3862 < f32(_e3869))));
let _e3874 = f32(_e3873);
let _e3878 = ((_e3856 - (_e3874 * 0.6933594f)) - (_e3874 * -2.1219444e-4f));
let _e3898 = ((1f + (_e3878 * (1f + (_e3878 * (0.5f + (_e3878 * (0.16666667f + (_e3878 * (0.041666668f + (_e3878 * (0.008333334f + (_e3878 * (0.001388889f + (_e3878 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3873 + 127i)) << bitcast<u32>(23i))));
let _e3899 = (1f - _e3898);
let _e3902 = (_e3899 / select(1e-12f, _e3848, (_e3848 > 1e-12f)));
phi_7321_ = type_31(_e3898, _e3899, vec3<f32>(1f, 1f, 1f), vec3<f32>(((_e3693 + (((_e3698 + (((bitcast<f32>(((_e3680 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3698) * _e3642)) - _e3693) * _e3640)) * _e3902), ((_e3730 + (((_e3735 + (((bitcast<f32>((((_e3680 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3735) * _e3642)) - _e3730) * _e3640)) * _e3902), ((_e3795 + (((_e3800 + (((bitcast<f32>(((_e3782 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3800) * _e3642)) - _e3795) * _e3640)) * _e3902)));
} else {
let _e3909 = (_e3206 * 255f);
let _e3910 = (_e2807.member * 255f);
let _e3911 = (255f - 1f);
let _e3913 = select(0f, _e3909, (_e3909 > 0f));
let _e3915 = select(_e3911, _e3913, (_e3913 < _e3911));
let _e3922 = select(0i, select(select(i32(_e3915), i32(-2147483648), (_e3915 < -2147483600f)), 2147483647i, (_e3915 > 2147483500f)), (_e3915 == _e3915));
let _e3926 = (_e3922 - select(0i, 1i, (_e3915 < f32(_e3922))));
let _e3928 = select(0f, _e3910, (_e3910 > 0f));
let _e3930 = select(_e3911, _e3928, (_e3928 < _e3911));
let _e3937 = select(0i, select(select(i32(_e3930), i32(-2147483648), (_e3930 < -2147483600f)), 2147483647i, (_e3930 > 2147483500f)), (_e3930 == _e3930));
let _e3941 = (_e3937 - select(0i, 1i, (_e3930 < f32(_e3937))));
let _e3944 = (((_e3926 * 256i) + _e3941) * 4i);
let _e3946 = (_e3909 - f32(_e3926));
let _e3948 = (_e3910 - f32(_e3941));
let _e3950 = (bitcast<i32>(_e121) - 1i);
let _e3952 = select(_e3950, _e3944, (_e3944 < _e3950));
let _e3958 = global_3.member[bitcast<u32>(select(0i, _e3952, (_e3952 > 0i)))];
let _e3959 = (_e3944 + 4i);
let _e3961 = select(_e3950, _e3959, (_e3959 < _e3950));
let _e3967 = global_3.member[bitcast<u32>(select(0i, _e3961, (_e3961 > 0i)))];
let _e3968 = (_e3944 + 1024i);
let _e3970 = select(_e3950, _e3968, (_e3968 < _e3950));
let _e3976 = global_3.member[bitcast<u32>(select(0i, _e3970, (_e3970 > 0i)))];
let _e3977 = (_e3944 + 1028i);
let _e3979 = select(_e3950, _e3977, (_e3977 < _e3950));
let _e3985 = global_3.member[bitcast<u32>(select(0i, _e3979, (_e3979 > 0i)))];
let _e3990 = (bitcast<f32>(((_e3958 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3998 = (_e3990 + (((bitcast<f32>(((_e3967 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3990) * _e3948));
let _e4003 = (bitcast<f32>(((_e3976 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4014 = (_e3998 + (((_e4003 + (((bitcast<f32>(((_e3985 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4003) * _e3948)) - _e3998) * _e3946));
let _e4027 = (bitcast<f32>((((_e3958 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4035 = (_e4027 + (((bitcast<f32>((((_e3967 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4027) * _e3948));
let _e4040 = (bitcast<f32>((((_e3976 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4052 = (_e3944 + 1i);
let _e4054 = select(_e3950, _e4052, (_e4052 < _e3950));
let _e4060 = global_3.member[bitcast<u32>(select(0i, _e4054, (_e4054 > 0i)))];
let _e4061 = (_e3944 + 5i);
let _e4063 = select(_e3950, _e4061, (_e4061 < _e3950));
let _e4069 = global_3.member[bitcast<u32>(select(0i, _e4063, (_e4063 > 0i)))];
let _e4070 = (_e3944 + 1025i);
let _e4072 = select(_e3950, _e4070, (_e4070 < _e3950));
let _e4078 = global_3.member[bitcast<u32>(select(0i, _e4072, (_e4072 > 0i)))];
let _e4079 = (_e3944 + 1029i);
let _e4081 = select(_e3950, _e4079, (_e4079 < _e3950));
let _e4087 = global_3.member[bitcast<u32>(select(0i, _e4081, (_e4081 > 0i)))];
let _e4092 = (bitcast<f32>(((_e4060 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4100 = (_e4092 + (((bitcast<f32>(((_e4069 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4092) * _e3948));
let _e4105 = (bitcast<f32>(((_e4078 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4129 = (bitcast<f32>((((_e4060 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4137 = (_e4129 + (((bitcast<f32>((((_e4069 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4129) * _e3948));
let _e4142 = (bitcast<f32>((((_e4078 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4154 = (_e3944 + 2i);
let _e4156 = select(_e3950, _e4154, (_e4154 < _e3950));
let _e4162 = global_3.member[bitcast<u32>(select(0i, _e4156, (_e4156 > 0i)))];
let _e4163 = (_e3944 + 6i);
let _e4165 = select(_e3950, _e4163, (_e4163 < _e3950));
let _e4171 = global_3.member[bitcast<u32>(select(0i, _e4165, (_e4165 > 0i)))];
let _e4172 = (_e3944 + 1026i);
let _e4174 = select(_e3950, _e4172, (_e4172 < _e3950));
let _e4180 = global_3.member[bitcast<u32>(select(0i, _e4174, (_e4174 > 0i)))];
let _e4181 = (_e3944 + 1030i);
let _e4183 = select(_e3950, _e4181, (_e4181 < _e3950));
let _e4189 = global_3.member[bitcast<u32>(select(0i, _e4183, (_e4183 > 0i)))];
let _e4194 = (bitcast<f32>(((_e4162 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4202 = (_e4194 + (((bitcast<f32>(((_e4171 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4194) * _e3948));
let _e4207 = (bitcast<f32>(((_e4180 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4231 = (bitcast<f32>((((_e4162 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4239 = (_e4231 + (((bitcast<f32>((((_e4171 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4231) * _e3948));
let _e4244 = (bitcast<f32>((((_e4180 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4256 = (_e3944 + 3i);
let _e4258 = select(_e3950, _e4256, (_e4256 < _e3950));
let _e4264 = global_3.member[bitcast<u32>(select(0i, _e4258, (_e4258 > 0i)))];
let _e4265 = (_e3944 + 7i);
let _e4267 = select(_e3950, _e4265, (_e4265 < _e3950));
let _e4273 = global_3.member[bitcast<u32>(select(0i, _e4267, (_e4267 > 0i)))];
let _e4274 = (_e3944 + 1027i);
let _e4276 = select(_e3950, _e4274, (_e4274 < _e3950));
let _e4282 = global_3.member[bitcast<u32>(select(0i, _e4276, (_e4276 > 0i)))];
let _e4283 = (_e3944 + 1031i);
let _e4285 = select(_e3950, _e4283, (_e4283 < _e3950));
let _e4291 = global_3.member[bitcast<u32>(select(0i, _e4285, (_e4285 > 0i)))];
let _e4296 = (bitcast<f32>(((_e4264 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4304 = (_e4296 + (((bitcast<f32>(((_e4273 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4296) * _e3948));
let _e4309 = (bitcast<f32>(((_e4282 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4324 = (_e3600 * _e3495.member_1);
let _e4326 = -(((_e4035 + (((_e4040 + (((bitcast<f32>((((_e3985 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4040) * _e3948)) - _e4035) * _e3946)) * _e4324));
let _e4328 = select(-87f, _e4326, (_e4326 > -87f));
let _e4330 = select(88f, _e4328, (_e4328 < 88f));
let _e4332 = ((_e4330 * 1.442695f) + 0.5f);
let _e4334 = select(-127f, _e4332, (_e4332 > -127f));
let _e4336 = select(128f, _e4334, (_e4334 < 128f));
let _e4343 = select(0i, select(select(i32(_e4336), i32(-2147483648), (_e4336 < -2147483600f)), 2147483647i, (_e4336 > 2147483500f)), (_e4336 == _e4336));
let _e4347 = (_e4343 - select(0i, 1i, (_e4336 < f32(_e4343))));
let _e4348 = f32(_e4347);
let _e4352 = ((_e4330 - (_e4348 * 0.6933594f)) - (_e4348 * -2.1219444e-4f));
let _e4374 = -(((_e4100 + (((_e4105 + (((bitcast<f32>(((_e4087 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4105) * _e3948)) - _e4100) * _e3946)) * _e4324));
let _e4376 = select(-87f, _e4374, (_e4374 > -87f));
let _e4378 = select(88f, _e4376, (_e4376 < 88f));
let _e4380 = ((_e4378 * 1.442695f) + 0.5f);
let _e4382 = select(-127f, _e4380, (_e4380 > -127f));
let _e4384 = select(128f, _e4382, (_e4382 < 128f));
let _e4391 = select(0i, select(select(i32(_e4384), i32(-2147483648), (_e4384 < -2147483600f)), 2147483647i, (_e4384 > 2147483500f)), (_e4384 == _e4384));
let _e4395 = (_e4391 - select(0i, 1i, (_e4384 < f32(_e4391))));
let _e4396 = f32(_e4395);
let _e4400 = ((_e4378 - (_e4396 * 0.6933594f)) - (_e4396 * -2.1219444e-4f));
let _e4422 = -(((_e4137 + (((_e4142 + (((bitcast<f32>((((_e4087 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4142) * _e3948)) - _e4137) * _e3946)) * _e4324));
let _e4424 = select(-87f, _e4422, (_e4422 > -87f));
let _e4426 = select(88f, _e4424, (_e4424 < 88f));
let _e4428 = ((_e4426 * 1.442695f) + 0.5f);
let _e4430 = select(-127f, _e4428, (_e4428 > -127f));
let _e4432 = select(128f, _e4430, (_e4430 < 128f));
let _e4439 = select(0i, select(select(i32(_e4432), i32(-2147483648), (_e4432 < -2147483600f)), 2147483647i, (_e4432 > 2147483500f)), (_e4432 == _e4432));
let _e4443 = (_e4439 - select(0i, 1i, (_e4432 < f32(_e4439))));
let _e4444 = f32(_e4443);
let _e4448 = ((_e4426 - (_e4444 * 0.6933594f)) - (_e4444 * -2.1219444e-4f));
let _e4471 = -((_e4014 * (_e3600 * _e3495.member)));
let _e4473 = select(-87f, _e4471, (_e4471 > -87f));
let _e4475 = select(88f, _e4473, (_e4473 < 88f));
let _e4477 = ((_e4475 * 1.442695f) + 0.5f);
let _e4479 = select(-127f, _e4477, (_e4477 > -127f));
let _e4481 = select(128f, _e4479, (_e4479 < 128f));
let _e4488 = select(0i, select(select(i32(_e4481), i32(-2147483648), (_e4481 < -2147483600f)), 2147483647i, (_e4481 > 2147483500f)), (_e4481 == _e4481));
let _e4492 = (_e4488 - select(0i, 1i, (_e4481 < f32(_e4488))));
let _e4493 = f32(_e4492);
let _e4497 = ((_e4475 - (_e4493 * 0.6933594f)) - (_e4493 * -2.1219444e-4f));
let _e4517 = ((1f + (_e4497 * (1f + (_e4497 * (0.5f + (_e4497 * (0.16666667f + (_e4497 * (0.041666668f + (_e4497 * (0.008333334f + (_e4497 * (0.001388889f + (_e4497 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4492 + 127i)) << bitcast<u32>(23i))));
let _e4518 = (1f - _e4517);
let _e4521 = (_e4518 / select(1e-12f, _e4014, (_e4014 > 1e-12f)));
phi_7321_ = type_31(_e4517, _e4518, vec3<f32>(((1f + (_e4352 * (1f + (_e4352 * (0.5f + (_e4352 * (0.16666667f + (_e4352 * (0.041666668f + (_e4352 * (0.008333334f + (_e4352 * (0.001388889f + (_e4352 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4347 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4400 * (1f + (_e4400 * (0.5f + (_e4400 * (0.16666667f + (_e4400 * (0.041666668f + (_e4400 * (0.008333334f + (_e4400 * (0.001388889f + (_e4400 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4395 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e4448 * (1f + (_e4448 * (0.5f + (_e4448 * (0.16666667f + (_e4448 * (0.041666668f + (_e4448 * (0.008333334f + (_e4448 * (0.001388889f + (_e4448 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4443 + 127i)) << bitcast<u32>(23i))))), vec3<f32>(((_e4202 + (((_e4207 + (((bitcast<f32>(((_e4189 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4207) * _e3948)) - _e4202) * _e3946)) * _e4521), ((_e4239 + (((_e4244 + (((bitcast<f32>((((_e4189 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4244) * _e3948)) - _e4239) * _e3946)) * _e4521), ((_e4304 + (((_e4309 + (((bitcast<f32>(((_e4291 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4309) * _e3948)) - _e4304) * _e3946)) * _e4521)));
}
let _e4528 = phi_7321_;
let _e4529 = select(0f, _e3282, _e440);
let _e4533 = (_e375 + (_e3582 * _e4529));
let _e4534 = (_e378 + (_e3583 * _e4529));
let _e4535 = (_e369 + (_e3584 * _e4529));
if (_e727.member_2 == 3u) {
let _e4541 = global_5.member[_e350].member_9.member_1;
let _e4550 = global_5.member[_e350].member_9.member;
phi_8304_ = type_25(vec3<f32>(_e4541.member, _e4541.member_1, _e4541.member_2), vec3<f32>(_e4550.member, _e4550.member_1, _e4550.member_2));
} else {
let _e4560 = global_5.member[_e350].member_8.member_8;
let _e4561 = (_e4535 - _e4560);
let _e4566 = global_5.member[_e350].member_8.member_2;
let _e4571 = global_5.member[_e350].member_8.member_6;
let _e4579 = global_5.member[_e350].member_8.member_5;
let _e4581 = (((_e4533 - (_e4566 + (_e4571 * _e4561))) * _e4579) - 0.5f);
let _e4586 = global_5.member[_e350].member_8.member_3;
let _e4591 = global_5.member[_e350].member_8.member_7;
let _e4596 = (((_e4534 - (_e4586 + (_e4591 * _e4561))) * _e4579) - 0.5f);
let _e4601 = global_5.member[_e350].member_8.member;
let _e4602 = bitcast<i32>(_e4601);
let _e4604 = (f32(_e4602) - 1f);
let _e4609 = global_5.member[_e350].member_8.member_1;
let _e4612 = (f32(bitcast<i32>(_e4609)) - 1f);
let _e4614 = select(0f, _e4581, (_e4581 > 0f));
let _e4616 = select(_e4604, _e4614, (_e4614 < _e4604));
let _e4623 = select(0i, select(select(i32(_e4616), i32(-2147483648), (_e4616 < -2147483600f)), 2147483647i, (_e4616 > 2147483500f)), (_e4616 == _e4616));
let _e4627 = (_e4623 - select(0i, 1i, (_e4616 < f32(_e4623))));
let _e4629 = select(0f, _e4596, (_e4596 > 0f));
let _e4631 = select(_e4612, _e4629, (_e4629 < _e4612));
let _e4638 = select(0i, select(select(i32(_e4631), i32(-2147483648), (_e4631 < -2147483600f)), 2147483647i, (_e4631 > 2147483500f)), (_e4631 == _e4631));
let _e4642 = (_e4638 - select(0i, 1i, (_e4631 < f32(_e4638))));
let _e4646 = (_e4581 - f32(_e4627));
let _e4648 = (_e4596 - f32(_e4642));
let _e4655 = ((((_e4581 >= 0f) && (_e4581 <= _e4604)) && (_e4596 >= 0f)) && (_e4596 <= _e4612));
let _e4659 = global_5.member[_e350].member_4;
let _e4660 = bitcast<i32>(_e4659);
let _e4662 = bitcast<i32>((_e4601 * _e4609));
let _e4664 = (_e4660 + (3i * _e4662));
local_1 = (_e4664 + ((_e4642 * _e4602) + _e4627));
let _e4666 = local_1;
let _e4668 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e4670 = select(_e4668, _e4666, (_e4666 < _e4668));
let _e4675 = global_6.member[bitcast<u32>(select(0i, _e4670, (_e4670 > 0i)))];
let _e4676 = bitcast<u32>(_e4675);
let _e4680 = f32((bitcast<i32>((_e4676 & 65535u)) - 32768i));
let _e4686 = f32((bitcast<i32>(((_e4676 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4691 = select(_e4686, -(_e4686), ((_e4676 >> bitcast<u32>(31i)) != 0u));
let _e4692 = local_1;
let _e4693 = (_e4692 + 1i);
let _e4695 = select(_e4668, _e4693, (_e4693 < _e4668));
let _e4700 = global_6.member[bitcast<u32>(select(0i, _e4695, (_e4695 > 0i)))];
let _e4701 = bitcast<u32>(_e4700);
let _e4711 = f32((bitcast<i32>(((_e4701 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4717 = local_1;
let _e4718 = (_e4717 + _e4602);
let _e4720 = select(_e4668, _e4718, (_e4718 < _e4668));
let _e4725 = global_6.member[bitcast<u32>(select(0i, _e4720, (_e4720 > 0i)))];
let _e4726 = bitcast<u32>(_e4725);
let _e4730 = f32((bitcast<i32>((_e4726 & 65535u)) - 32768i));
let _e4736 = f32((bitcast<i32>(((_e4726 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4741 = select(_e4736, -(_e4736), ((_e4726 >> bitcast<u32>(31i)) != 0u));
let _e4742 = (_e4602 + 1i);
let _e4743 = local_1;
let _e4744 = (_e4743 + _e4742);
let _e4746 = select(_e4668, _e4744, (_e4744 < _e4668));
let _e4751 = global_6.member[bitcast<u32>(select(0i, _e4746, (_e4746 > 0i)))];
let _e4752 = bitcast<u32>(_e4751);
let _e4762 = f32((bitcast<i32>(((_e4752 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e4770 = (_e4680 + ((f32((bitcast<i32>((_e4701 & 65535u)) - 32768i)) - _e4680) * _e4646));
let _e4779 = (_e4691 + ((select(_e4711, -(_e4711), ((_e4701 >> bitcast<u32>(31i)) != 0u)) - _e4691) * _e4646));
let _e4792 = global_5.member[_e350].member_9.member;
let _e4795 = (1f / 16255f);
let _e4797 = (_e4792.member + (select(0f, (_e4770 + (((_e4730 + ((f32((bitcast<i32>((_e4752 & 65535u)) - 32768i)) - _e4730) * _e4646)) - _e4770) * _e4648)), _e4655) * _e4795));
let _e4799 = (_e4792.member_1 + (select(0f, (_e4779 + (((_e4741 + ((select(_e4762, -(_e4762), ((_e4752 >> bitcast<u32>(31i)) != 0u)) - _e4741) * _e4646)) - _e4779) * _e4648)), _e4655) * _e4795));
let _e4803 = (1f - ((_e4797 * _e4797) + (_e4799 * _e4799)));
let _e4805 = select(1e-4f, _e4803, (_e4803 > 1e-4f));
let _e4808 = sqrt(select(0f, _e4805, (_e4805 > 0f)));
let _e4812 = (1f / select(1e-6f, _e4808, (_e4808 > 1e-6f)));
let _e4813 = ((_e4535 - _e369) * _e4579);
let _e4820 = (_e4581 - (((_e4797 * _e4812) - _e4571) * _e4813));
let _e4821 = (_e4596 - (((_e4799 * _e4812) - _e4591) * _e4813));
let _e4823 = select(0f, _e4820, (_e4820 > 0f));
let _e4825 = select(_e4604, _e4823, (_e4823 < _e4604));
let _e4832 = select(0i, select(select(i32(_e4825), i32(-2147483648), (_e4825 < -2147483600f)), 2147483647i, (_e4825 > 2147483500f)), (_e4825 == _e4825));
let _e4836 = (_e4832 - select(0i, 1i, (_e4825 < f32(_e4832))));
let _e4838 = select(0f, _e4821, (_e4821 > 0f));
let _e4840 = select(_e4612, _e4838, (_e4838 < _e4612));
let _e4847 = select(0i, select(select(i32(_e4840), i32(-2147483648), (_e4840 < -2147483600f)), 2147483647i, (_e4840 > 2147483500f)), (_e4840 == _e4840));
let _e4851 = (_e4847 - select(0i, 1i, (_e4840 < f32(_e4847))));
let _e4853 = ((_e4851 * _e4602) + _e4836);
let _e4855 = (_e4820 - f32(_e4836));
let _e4857 = (_e4821 - f32(_e4851));
let _e4864 = ((((_e4820 >= 0f) && (_e4820 <= _e4604)) && (_e4821 >= 0f)) && (_e4821 <= _e4612));
let _e4865 = (_e4660 + _e4853);
let _e4867 = select(_e4668, _e4865, (_e4865 < _e4668));
let _e4873 = global_6.member[bitcast<u32>(select(0i, _e4867, (_e4867 > 0i)))];
let _e4874 = (_e4865 + 1i);
let _e4876 = select(_e4668, _e4874, (_e4874 < _e4668));
let _e4882 = global_6.member[bitcast<u32>(select(0i, _e4876, (_e4876 > 0i)))];
let _e4885 = (_e4873 + ((_e4882 - _e4873) * _e4855));
let _e4886 = (_e4865 + _e4602);
let _e4888 = select(_e4668, _e4886, (_e4886 < _e4668));
let _e4894 = global_6.member[bitcast<u32>(select(0i, _e4888, (_e4888 > 0i)))];
let _e4895 = (_e4886 + 1i);
let _e4897 = select(_e4668, _e4895, (_e4895 < _e4668));
let _e4903 = global_6.member[bitcast<u32>(select(0i, _e4897, (_e4897 > 0i)))];
let _e4910 = select(1f, (_e4885 + (((_e4894 + ((_e4903 - _e4894) * _e4855)) - _e4885) * _e4857)), _e4864);
if _e3601 {
phi_8074_ = vec3(_e4910);
} else {
let _e4913 = ((_e4660 + _e4662) + _e4853);
let _e4915 = select(_e4668, _e4913, (_e4913 < _e4668));
let _e4921 = global_6.member[bitcast<u32>(select(0i, _e4915, (_e4915 > 0i)))];
let _e4922 = (_e4913 + 1i);
let _e4924 = select(_e4668, _e4922, (_e4922 < _e4668));
let _e4930 = global_6.member[bitcast<u32>(select(0i, _e4924, (_e4924 > 0i)))];
let _e4933 = (_e4921 + ((_e4930 - _e4921) * _e4855));
let _e4934 = (_e4913 + _e4602);
let _e4936 = select(_e4668, _e4934, (_e4934 < _e4668));
let _e4942 = global_6.member[bitcast<u32>(select(0i, _e4936, (_e4936 > 0i)))];
let _e4943 = (_e4934 + 1i);
let _e4945 = select(_e4668, _e4943, (_e4943 < _e4668));
let _e4951 = global_6.member[bitcast<u32>(select(0i, _e4945, (_e4945 > 0i)))];
let _e4961 = ((_e4660 + (2i * _e4662)) + _e4853);
let _e4963 = select(_e4668, _e4961, (_e4961 < _e4668));
let _e4969 = global_6.member[bitcast<u32>(select(0i, _e4963, (_e4963 > 0i)))];
let _e4970 = (_e4961 + 1i);
let _e4972 = select(_e4668, _e4970, (_e4970 < _e4668));
let _e4978 = global_6.member[bitcast<u32>(select(0i, _e4972, (_e4972 > 0i)))];
let _e4981 = (_e4969 + ((_e4978 - _e4969) * _e4855));
let _e4982 = (_e4961 + _e4602);
let _e4984 = select(_e4668, _e4982, (_e4982 < _e4668));
let _e4990 = global_6.member[bitcast<u32>(select(0i, _e4984, (_e4984 > 0i)))];
let _e4991 = (_e4982 + 1i);
let _e4993 = select(_e4668, _e4991, (_e4991 < _e4668));
let _e4999 = global_6.member[bitcast<u32>(select(0i, _e4993, (_e4993 > 0i)))];
phi_8074_ = vec3<f32>(_e4910, select(1f, (_e4933 + (((_e4942 + ((_e4951 - _e4942) * _e4855)) - _e4933) * _e4857)), _e4864), select(1f, (_e4981 + (((_e4990 + ((_e4999 - _e4990) * _e4855)) - _e4981) * _e4857)), _e4864));
}
let _e5009 = phi_8074_;
local = (_e4664 + _e4853);
let _e5011 = local;
let _e5013 = select(_e4668, _e5011, (_e5011 < _e4668));
let _e5018 = global_6.member[bitcast<u32>(select(0i, _e5013, (_e5013 > 0i)))];
let _e5019 = bitcast<u32>(_e5018);
let _e5023 = f32((bitcast<i32>((_e5019 & 65535u)) - 32768i));
let _e5029 = f32((bitcast<i32>(((_e5019 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5034 = select(_e5029, -(_e5029), ((_e5019 >> bitcast<u32>(31i)) != 0u));
let _e5035 = local;
let _e5036 = (_e5035 + 1i);
let _e5038 = select(_e4668, _e5036, (_e5036 < _e4668));
let _e5043 = global_6.member[bitcast<u32>(select(0i, _e5038, (_e5038 > 0i)))];
let _e5044 = bitcast<u32>(_e5043);
let _e5054 = f32((bitcast<i32>(((_e5044 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5060 = local;
let _e5061 = (_e5060 + _e4602);
let _e5063 = select(_e4668, _e5061, (_e5061 < _e4668));
let _e5068 = global_6.member[bitcast<u32>(select(0i, _e5063, (_e5063 > 0i)))];
let _e5069 = bitcast<u32>(_e5068);
let _e5073 = f32((bitcast<i32>((_e5069 & 65535u)) - 32768i));
let _e5079 = f32((bitcast<i32>(((_e5069 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5084 = select(_e5079, -(_e5079), ((_e5069 >> bitcast<u32>(31i)) != 0u));
let _e5085 = local;
let _e5086 = (_e5085 + _e4742);
let _e5088 = select(_e4668, _e5086, (_e5086 < _e4668));
let _e5093 = global_6.member[bitcast<u32>(select(0i, _e5088, (_e5088 > 0i)))];
let _e5094 = bitcast<u32>(_e5093);
let _e5104 = f32((bitcast<i32>(((_e5094 >> bitcast<u32>(16i)) & 32767u)) - 128i));
let _e5112 = (_e5023 + ((f32((bitcast<i32>((_e5044 & 65535u)) - 32768i)) - _e5023) * _e4855));
let _e5121 = (_e5034 + ((select(_e5054, -(_e5054), ((_e5044 >> bitcast<u32>(31i)) != 0u)) - _e5034) * _e4855));
let _e5134 = global_5.member[_e350].member_9.member_1;
let _e5141 = (_e4792.member + (select(0f, (_e5112 + (((_e5073 + ((f32((bitcast<i32>((_e5094 & 65535u)) - 32768i)) - _e5073) * _e4855)) - _e5112) * _e4857)), _e4864) * _e4795));
let _e5143 = (_e4792.member_1 + (select(0f, (_e5121 + (((_e5084 + ((select(_e5104, -(_e5104), ((_e5094 >> bitcast<u32>(31i)) != 0u)) - _e5084) * _e4855)) - _e5121) * _e4857)), _e4864) * _e4795));
let _e5147 = (1f - ((_e5141 * _e5141) + (_e5143 * _e5143)));
let _e5149 = select(1e-4f, _e5147, (_e5147 > 1e-4f));
phi_8304_ = type_25((_e5009 * vec3<f32>(_e5134.member, _e5134.member_1, _e5134.member_2)), vec3<f32>(_e5141, _e5143, sqrt(select(0f, _e5149, (_e5149 > 0f)))));
}
let _e5156 = phi_8304_;
let _e5165 = (((_e5156.member_1.x * _e5156.member_1.x) + (_e5156.member_1.y * _e5156.member_1.y)) + (_e5156.member_1.z * _e5156.member_1.z));
let _e5168 = sqrt(select(0f, _e5165, (_e5165 > 0f)));
let _e5174 = (1e-6f * _e5168);
let _e5178 = select((_e5168 / select(_e5174, _e5156.member_1.z, (_e5156.member_1.z > _e5174))), 1f, ((_e683 & 8u) != 0u));
let _e5180 = (_e5156.member.x * _e5178);
let _e5182 = (_e5156.member.y * _e5178);
let _e5184 = (_e5156.member.z * _e5178);
if _e790 {
let _e5189 = global_5.member[_e350].member_19;
let _e5198 = (((_e2807.member_1.x * _e2807.member_1.x) + (_e2807.member_1.y * _e2807.member_1.y)) + (_e2807.member_1.z * _e2807.member_1.z));
let _e5201 = sqrt(select(0f, _e5198, (_e5198 > 0f)));
let _e5204 = (1f / select(1e-20f, _e5201, (_e5201 > 1e-20f)));
let _e5205 = (_e2807.member_1.x * _e5204);
let _e5206 = (_e2807.member_1.y * _e5204);
let _e5207 = (_e2807.member_1.z * _e5204);
let _e5210 = (-1f / select(1e-20f, _e5168, (_e5168 > 1e-20f)));
let _e5211 = (_e5156.member_1.x * _e5210);
let _e5212 = (_e5156.member_1.y * _e5210);
let _e5213 = (_e5156.member_1.z * _e5210);
let _e5218 = (((_e354[2] * _e354[2]) + (_e354[3] * _e354[3])) + (_e354[4] * _e354[4]));
let _e5221 = sqrt(select(0f, _e5218, (_e5218 > 0f)));
let _e5224 = (-1f / select(1e-20f, _e5221, (_e5221 > 1e-20f)));
let _e5225 = (_e354[2] * _e5224);
let _e5226 = (_e354[3] * _e5224);
let _e5227 = (_e354[4] * _e5224);
let _e5234 = select(1f, -1f, ((((_e5205 * _e5225) + (_e5206 * _e5226)) + (_e5207 * _e5227)) < 0f));
let _e5235 = (_e5205 * _e5234);
let _e5236 = (_e5206 * _e5234);
let _e5237 = (_e5207 * _e5234);
let _e5242 = (((_e5235 * _e5225) + (_e5236 * _e5226)) + (_e5237 * _e5227));
let _e5244 = select(1e-4f, _e5242, (_e5242 > 1e-4f));
let _e5249 = (((_e5235 * _e5211) + (_e5236 * _e5212)) + (_e5237 * _e5213));
let _e5250 = (_e5211 + _e5225);
let _e5251 = (_e5212 + _e5226);
let _e5252 = (_e5213 + _e5227);
let _e5257 = (((_e5250 * _e5250) + (_e5251 * _e5251)) + (_e5252 * _e5252));
let _e5260 = sqrt(select(0f, _e5257, (_e5257 > 0f)));
let _e5263 = (1f / select(1e-6f, _e5260, (_e5260 > 1e-6f)));
let _e5264 = (_e5250 * _e5263);
let _e5265 = (_e5251 * _e5263);
let _e5266 = (_e5252 * _e5263);
let _e5271 = (((_e5235 * _e5264) + (_e5236 * _e5265)) + (_e5237 * _e5266));
let _e5273 = select(0f, _e5271, (_e5271 > 0f));
let _e5278 = (((_e5225 * _e5264) + (_e5226 * _e5265)) + (_e5227 * _e5266));
let _e5280 = select(0f, _e5278, (_e5278 > 0f));
let _e5281 = (_e5189 * _e5189);
let _e5282 = (_e5281 * _e5281);
let _e5286 = (((_e5273 * _e5273) * (_e5282 - 1f)) + 1f);
let _e5290 = (_e5249 > 0f);
let _e5291 = select(0f, _e5249, _e5290);
let _e5293 = (1f - _e5282);
let _e5295 = (((_e5291 * _e5291) * _e5293) + _e5282);
let _e5302 = (((_e5244 * _e5244) * _e5293) + _e5282);
let _e5307 = ((_e5244 * sqrt(select(0f, _e5295, (_e5295 > 0f)))) + (_e5291 * sqrt(select(0f, _e5302, (_e5302 > 0f)))));
let _e5312 = (_e2807.member_2 / _e3279);
let _e5316 = (((_e5312 * _e5312) - 1f) + (_e5280 * _e5280));
let _e5319 = sqrt(select(0f, _e5316, (_e5316 > 0f)));
let _e5320 = (_e5319 - _e5280);
let _e5321 = (_e5319 + _e5280);
let _e5324 = (_e5320 / select(1e-6f, _e5321, (_e5321 > 1e-6f)));
let _e5328 = ((_e5280 * _e5320) + 1f);
let _e5331 = (((_e5280 * _e5321) - 1f) / select(1e-6f, _e5328, (_e5328 > 1e-6f)));
let _e5349 = global_5.member[_e350].member_20;
let _e5353 = ((select(0f, ((((_e5282 / ((3.1415927f * _e5286) * _e5286)) * (0.5f / select(1e-6f, _e5307, (_e5307 > 1e-6f)))) * select(select((((0.5f * _e5324) * _e5324) * (1f + (_e5331 * _e5331))), 1f, (_e5316 <= 0f)), 0f, (_e3279 == _e2807.member_2))) * _e5291), (_e5290 && (_e5201 > 1e-12f))) * _e5349) * select(_e3495.member_2, 0f, _e440));
phi_8622_ = vec3<f32>((_e5180 * _e5353), (_e5182 * _e5353), (_e5184 * _e5353));
} else {
phi_8622_ = vec3<f32>(0f, 0f, 0f);
}
let _e5359 = phi_8622_;
let _e5370 = global_5.member[_e350].member_18;
let _e5377 = (1f - _e354[11]);
let _e5397 = (_e354[8] + ((_e354[12] * ((_e4528.member_3.x * (_e5180 + _e5370.member)) + _e5359.x)) * _e5377));
let _e5398 = (_e354[9] + ((_e354[13] * ((_e4528.member_3.y * (_e5182 + _e5370.member_1)) + _e5359.y)) * _e5377));
let _e5399 = (_e354[10] + ((_e354[14] * ((_e4528.member_3.z * (_e5184 + _e5370.member_2)) + _e5359.z)) * _e5377));
let _e5402 = (_e354[11] + (_e5377 * _e4528.member_1));
let _e5405 = (_e354[12] * _e4528.member_2.x);
let _e5407 = (_e354[13] * _e4528.member_2.y);
let _e5409 = (_e354[14] * _e4528.member_2.z);
let _e5415 = (_e354[7] + ((_e5402 - _e354[11]) * (_e369 + (_e3584 * 0.5f))));
let _e5424 = (-((((select(_e760.member, _e747.member, _e740) * _e5156.member_1.x) + (select(_e760.member_1, _e747.member_1, _e740) * _e5156.member_1.y)) + (select(_e760.member_2, _e747.member_2, _e740) * _e5156.member_1.z))) / select(1e-20f, _e5168, (_e5168 > 1e-20f)));
let _e5429 = bitcast<f32>((bitcast<u32>(select(0f, _e5424, (_e5424 > 0f))) & 2147483647u));
let _e5439 = (1f - _e5402);
let _e5452 = select(_e5402, 1f, _e440);
if _e790 {
let _e5461 = global_5.member[_e350].member_5.member_4;
let _e5464 = (_e2807.member_3.x * _e3495.member_2);
let _e5466 = (_e2807.member_3.y * _e3495.member_2);
let _e5468 = (_e2807.member_3.z * _e3495.member_2);
let _e5469 = (0.5f * _e364);
let _e5473 = (_e354[2] + (_e5464 * _e5469));
let _e5474 = (_e354[3] + (_e5466 * _e5469));
let _e5475 = (_e354[4] + (_e5468 * _e5469));
let _e5477 = (2f * _e363);
let _e5479 = ((_e5475 * _e5475) + (_e5477 * _e5468));
let _e5483 = (_e5475 + sqrt(select(0f, _e5479, (_e5479 > 0f))));
let _e5487 = (0.5f * (_e5477 / select(1e-6f, _e5483, (_e5483 > 1e-6f))));
let _e5491 = (_e5473 + (_e5464 * _e5487));
let _e5492 = (_e5474 + (_e5466 * _e5487));
let _e5493 = (_e5475 + (_e5468 * _e5487));
let _e5497 = (_e5461 * _e5461);
let _e5499 = (_e5493 * _e5493);
let _e5507 = (((_e5475 <= 0f) || (_e5479 <= 0f)) || ((_e5493 <= 0f) || (_e5499 <= (_e5497 * (((_e5491 * _e5491) + (_e5492 * _e5492)) + _e5499)))));
let _e5521 = (_e354[2] + ((_e2807.member_4.x * _e3495.member_2) * _e363));
let _e5522 = (_e354[3] + ((_e2807.member_4.y * _e3495.member_2) * _e363));
let _e5523 = (_e354[4] + ((_e2807.member_4.z * _e3495.member_2) * _e363));
let _e5525 = (_e5523 * _e5523);
let _e5534 = ((_e683 & 1u) != 0u);
phi_8931_ = select(select(_e5493, _e5475, _e5507), _e5523, _e5534);
phi_8932_ = select(select(_e5492, _e5474, _e5507), _e5522, _e5534);
phi_8933_ = select(select(_e5491, _e5473, _e5507), _e5521, _e5534);
phi_8934_ = select(_e5507, ((_e5523 <= 0f) || (_e5525 <= (_e5497 * (((_e5521 * _e5521) + (_e5522 * _e5522)) + _e5525)))), _e5534);
} else {
phi_8931_ = _e354[4];
phi_8932_ = _e354[3];
phi_8933_ = _e354[2];
phi_8934_ = false;
}
let _e5540 = phi_8931_;
let _e5542 = phi_8932_;
let _e5544 = phi_8933_;
let _e5546 = phi_8934_;
let _e5552 = (((_e440 || (_e5544 != _e354[2])) || (_e5542 != _e354[3])) || (_e5540 != _e354[4]));
let _e5554 = select(_e5407, _e5405, (_e5405 > _e5407));
phi_8994_ = array<f32, 18>(select(_e354[0], select(_e380, _e4533, _e440), _e5552), select(_e354[1], select(_e382, _e4534, _e440), _e5552), _e5544, _e5542, _e5540, _e2807.member, select(select(0f, 2f, _e5546), 1f, (_e440 || (((1f - _e5452) * select(_e5409, _e5554, (_e5554 > _e5409))) < 9.765625e-4f))), select(_e5415, (_e5415 + (_e5439 * _e4535)), _e440), select(_e5397, (_e5397 + ((_e5405 * (select(_e766.member, _e753.member, _e740) * ((_e5180 * _e5429) + _e5370.member))) * _e5439)), _e440), select(_e5398, (_e5398 + ((_e5407 * (select(_e766.member_1, _e753.member_1, _e740) * ((_e5182 * _e5429) + _e5370.member_1))) * _e5439)), _e440), select(_e5399, (_e5399 + ((_e5409 * (select(_e766.member_2, _e753.member_2, _e740) * ((_e5184 * _e5429) + _e5370.member_2))) * _e5439)), _e440), _e5452, _e5405, _e5407, _e5409, _e2807.member_2, select(_e354[16], select(_e387, _e4535, _e440), _e5552), _e387);
} else {
phi_8994_ = _e354;
}
let _e5573 = phi_8994_;
phi_581_ = (_e350 + 1u);
phi_584_ = select(_e352, true, _e723);
phi_586_ = _e5573;
} else {
phi_581_ = u32();
phi_584_ = bool();
phi_586_ = array<f32, 18>();
}
let _e5577 = phi_581_;
let _e5579 = phi_584_;
let _e5581 = phi_586_;
continue;
continuing {
phi_580_ = _e5577;
phi_583_ = _e5579;
phi_585_ = _e5581;
phi_9077_ = false;
break if !(_e355);
}
}
let _e5584 = phi_9077_;
if _e5584 {
break;
}
let _e5586 = local_8;
if _e5586 {
let _e5588 = local_9;
global_4.member[_e150] = _e5588[0];
let _e5593 = local_10;
global_4.member[_e162] = _e5593[1];
let _e5598 = local_11;
global_4.member[_e173] = _e5598[2];
let _e5603 = local_12;
global_4.member[_e184] = _e5603[3];
let _e5608 = local_13;
global_4.member[_e195] = _e5608[4];
let _e5613 = local_14;
global_4.member[_e206] = _e5613[5];
let _e5618 = local_15;
global_4.member[_e217] = _e5618[6];
let _e5623 = local_16;
global_4.member[_e228] = _e5623[7];
let _e5628 = local_17;
global_4.member[_e239] = _e5628[8];
let _e5633 = local_18;
global_4.member[_e250] = _e5633[9];
let _e5638 = local_19;
global_4.member[_e261] = _e5638[10];
let _e5643 = local_20;
global_4.member[_e272] = _e5643[11];
let _e5648 = local_21;
global_4.member[_e283] = _e5648[12];
let _e5653 = local_22;
global_4.member[_e294] = _e5653[13];
let _e5658 = local_23;
global_4.member[_e305] = _e5658[14];
let _e5663 = local_24;
global_4.member[_e316] = _e5663[15];
let _e5668 = local_25;
global_4.member[_e327] = _e5668[16];
let _e5673 = local_26;
global_4.member[_e338] = _e5673[17];
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
